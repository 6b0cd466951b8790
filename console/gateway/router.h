#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "console/gateway/http.h"
#include "console/gateway/url.h"

namespace tacit::gateway {

using AnyHandler = std::variant<Handler, LaterHandler>;

/// Which handler answers what.
class Router {
 public:
  struct Route {
    Method method = Method::Get;
    std::vector<std::string> pattern;
    AnyHandler handler;
    Accepts accepts;
  };
  struct Found {
    const Route* route = nullptr;      ///< Null when there is none.
    Request::Fields parameters = {};   ///< Of the route.
    std::vector<std::string> allowed;  ///< Methods of the path, when none is the one wanted.
  };

  /// Throws std::invalid_argument when there is such a route or the pattern has no slash first.
  void add(Method method, std::string_view pattern, AnyHandler handler, Accepts accepts);
  [[nodiscard]] Found find(Method method, const std::vector<std::string>& parts) const;
  /// Whether a route begins with the first of these parts: what lies below is no static file.
  [[nodiscard]] bool owns(const std::vector<std::string>& parts) const;

 private:
  std::vector<Route> routes_;
};

[[nodiscard]] std::string_view name_of(Method method);

}  // namespace tacit::gateway
