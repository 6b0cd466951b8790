#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "console/gateway/guard.h"
#include "console/gateway/http.h"
#include "console/gateway/router.h"
#include "console/gateway/server.h"
#include "console/gateway/static_files.h"
#include "console/gateway/url.h"

namespace tacit::gateway {

/// Decides what a request gets. Knows no socket.
class Desk {
 public:
  /// `config` with its token filled in.
  explicit Desk(const ServerConfig& config);

  Router& router() { return router_; }

  /// What the request gets when it may not come in: by its Host, its Origin or its token.
  /// `changes` says that it could do harm if a stranger's page had sent it.
  [[nodiscard]] std::optional<Response> refusal(const Request& request, bool changes) const;
  /// What it gets otherwise. Absent when a handler answers later, by what `later` gave.
  [[nodiscard]] std::optional<Response> answer(const Request& request, std::string_view raw_target,
                                               const std::function<Responder()>& later) const;

 private:
  [[nodiscard]] Response from_files(const Request& request, const Target& target,
                                    std::string_view raw_target) const;

  Guard guard_;
  StaticFiles files_;
  Router router_;
};

/// 405 with the methods that are right.
[[nodiscard]] Response not_allowed(const std::vector<std::string>& allowed);

}  // namespace tacit::gateway
