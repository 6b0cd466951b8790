#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "console/gateway/hub.h"

namespace tacit::gateway {

/// Serves HTTP on a socket that was accepted; upgrades go on as WebSockets.
void serve_http(const std::shared_ptr<Hub>& hub, boost::asio::ip::tcp::socket socket);
/// The same, but says to the first request that there are too many connections.
void serve_refusal(const std::shared_ptr<Hub>& hub, boost::asio::ip::tcp::socket socket);

}  // namespace tacit::gateway
