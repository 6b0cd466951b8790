#pragma once

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "console/gateway/hub.h"

namespace tacit::gateway {

/// The sub-protocol to speak with a client that offers this list; absent when there is none.
[[nodiscard]] std::optional<std::string> chosen_protocol(std::string_view offered);

/// An upgrade that may come in.
struct Upgrade {
  boost::beast::tcp_stream stream;
  boost::beast::http::request<boost::beast::http::string_body> request;
  std::string protocol;
  std::shared_ptr<SessionState> session;
  Ticket ticket;
};
void serve_websocket(const std::shared_ptr<Hub>& hub, Upgrade upgrade);

}  // namespace tacit::gateway
