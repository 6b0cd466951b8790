#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "console/gateway/http.h"

namespace tacit::gateway {

/// A random word that cannot be guessed: 32 hexadecimal digits of the system's chance.
[[nodiscard]] std::string new_token();

/// True for 127.0.0.0/8, ::1 and the name localhost.
[[nodiscard]] bool is_loopback(std::string_view address);

/// Who may use a server.
class Guard {
 public:
  struct Rules {
    std::string address;               ///< That the server is bound to.
    std::string token;                 ///< "" lets everybody in.
    std::vector<std::string> hosts;    ///< Further names of the server, without port.
    std::vector<std::string> origins;  ///< Further origins, as browsers write them.
  };
  explicit Guard(Rules rules);

  /// Whether a request to this `Host` is meant for the server. A page of a stranger, whose name
  /// was made to point here (DNS rebinding), comes with the stranger's name.
  [[nodiscard]] bool knows_host(std::string_view host) const;
  /// Whether a page of this `Origin` may upgrade or change something; "" is no page.
  [[nodiscard]] bool lets_in(std::string_view origin, std::string_view host) const;
  /// Whether the request holds the token; in its header, query or cookie.
  [[nodiscard]] bool is_authorized(const Request& request) const;
  /// Whether the token came in the query.
  [[nodiscard]] bool has_token_in_query(const Request& request) const;
  /// The header line's value that makes a browser send the token from now on.
  [[nodiscard]] std::string cookie() const;

 private:
  [[nodiscard]] bool is_token(std::string_view word) const;

  Rules rules_;
};

}  // namespace tacit::gateway
