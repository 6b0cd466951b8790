#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tacit::gateway {

/// Undoes %XX; absent when one is not two hexadecimal digits, or stands for NUL.
[[nodiscard]] std::optional<std::string> percent_decoded(std::string_view text);

/// The address of a request, taken apart.
struct Target {
  /// Parts of the path between slashes, decoded: "/a//b/" has "a", "", "b" and "".
  std::vector<std::string> parts;
  std::vector<std::pair<std::string, std::string>> query;

  [[nodiscard]] std::string path() const;
};

/// Absent unless `target` begins with a slash and decodes. A `+` in the query is a space.
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

/// Of A to Z alone.
[[nodiscard]] std::string lower_case(std::string_view text);

/// "[::1]:80" gives "[::1]", "Example:80" gives "example"; what is no host with a port stays as it
/// is.
[[nodiscard]] std::string host_without_port(std::string_view host);

}  // namespace tacit::gateway
