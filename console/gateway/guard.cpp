#include "console/gateway/guard.h"

#include <arpa/inet.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include "console/gateway/url.h"

namespace tacit::gateway {
namespace {

constexpr std::string_view kCookie = "gateway_token=";

bool is_ip(const std::string& text) {
  std::array<unsigned char, 16> bytes{};
  return ::inet_pton(AF_INET, text.c_str(), bytes.data()) == 1 ||
         ::inet_pton(AF_INET6, text.c_str(), bytes.data()) == 1;
}

std::string without_brackets(std::string_view host) {
  const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
  return std::string(bracketed ? host.substr(1, host.size() - 2) : host);
}

bool holds(const std::vector<std::string>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

std::string new_token() {
  std::array<std::uint8_t, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the system has no random bytes");
  }
  std::string token;
  for (const std::uint8_t byte : bytes) {
    token += "0123456789abcdef"[byte >> 4U];
    token += "0123456789abcdef"[byte & 15U];
  }
  return token;
}

bool is_loopback(std::string_view address) {
  return address == "localhost" || address == "::1" ||
         (address.starts_with("127.") && is_ip(std::string(address)));
}

Guard::Guard(Rules rules) : rules_(std::move(rules)) {}

bool Guard::knows_host(std::string_view host) const {
  const std::string name = without_brackets(host_without_port(host));
  if (is_loopback(name) || name == rules_.address || holds(rules_.hosts, name)) {
    return true;
  }
  const bool anywhere = rules_.address == "0.0.0.0" || rules_.address == "::";
  return anywhere && is_ip(name);
}

bool Guard::lets_in(std::string_view origin, std::string_view host) const {
  if (origin.empty() || holds(rules_.origins, origin)) {
    return true;
  }
  const std::size_t scheme = origin.find("://");
  const std::string_view name = scheme == std::string_view::npos ? "" : origin.substr(0, scheme);
  return (name == "http" || name == "https") && origin.substr(scheme + 3) == host;
}

bool Guard::is_authorized(const Request& request) const {
  if (rules_.token.empty() || has_token_in_query(request)) {
    return true;
  }
  constexpr std::string_view kBearer = "Bearer ";
  const std::string_view line = request.header("authorization");
  if (line.starts_with(kBearer)) {
    return is_token(line.substr(kBearer.size()));
  }
  std::string_view cookies = request.header("cookie");
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view one = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    one.remove_prefix(std::min(one.find_first_not_of(' '), one.size()));
    if (one.starts_with(kCookie) && is_token(one.substr(kCookie.size()))) {
      return true;
    }
  }
  return false;
}

bool Guard::has_token_in_query(const Request& request) const {
  return !rules_.token.empty() && is_token(request.in_query("token"));
}

std::string Guard::cookie() const {
  return std::string(kCookie) + rules_.token + "; Path=/; HttpOnly; SameSite=Strict";
}

bool Guard::is_token(std::string_view word) const {
  // As long for a wrong word as for the right one: the time tells nothing of it.
  unsigned differs = word.size() == rules_.token.size() ? 0 : 1;
  for (std::size_t i = 0; i < rules_.token.size(); ++i) {
    const char given = i < word.size() ? word[i] : '\0';
    differs |= static_cast<unsigned>(given ^ rules_.token[i]);
  }
  return differs == 0;
}

}  // namespace tacit::gateway
