#include "console/gateway/url.h"

#include <algorithm>

namespace tacit::gateway {
namespace {

std::optional<unsigned> hex_digit(char c) {
  if (c >= '0' && c <= '9') {
    return static_cast<unsigned>(c - '0');
  }
  const char lower = static_cast<char>(c | 0x20);
  if (lower >= 'a' && lower <= 'f') {
    return static_cast<unsigned>(lower - 'a') + 10U;
  }
  return std::nullopt;
}

/// Calls `each` with the pieces of `text` between separators.
template <typename Each>
bool for_pieces(std::string_view text, char separator, Each each) {
  while (true) {
    const std::size_t end = text.find(separator);
    if (!each(text.substr(0, end))) {
      return false;
    }
    if (end == std::string_view::npos) {
      return true;
    }
    text.remove_prefix(end + 1);
  }
}

std::optional<std::string> form_decoded(std::string_view text) {
  std::string spaced(text);
  std::replace(spaced.begin(), spaced.end(), '+', ' ');
  return percent_decoded(spaced);
}

bool add_field(std::string_view piece, Target& target) {
  if (piece.empty()) {
    return true;
  }
  const std::size_t equals = std::min(piece.find('='), piece.size());
  const auto name = form_decoded(piece.substr(0, equals));
  const auto value = form_decoded(piece.substr(std::min(equals + 1, piece.size())));
  if (!name || !value) {
    return false;
  }
  target.query.emplace_back(*name, *value);
  return true;
}

bool add_part(std::string_view piece, Target& target) {
  auto part = percent_decoded(piece);
  if (!part) {
    return false;
  }
  target.parts.push_back(std::move(*part));
  return true;
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const auto high = i + 2 < text.size() ? hex_digit(text[i + 1]) : std::nullopt;
    const auto low = i + 2 < text.size() ? hex_digit(text[i + 2]) : std::nullopt;
    if (!high || !low || *high + *low == 0) {
      return std::nullopt;
    }
    decoded += static_cast<char>(*high * 16U + *low);
    i += 2;
  }
  return decoded;
}

std::string Target::path() const {
  std::string path;
  for (const std::string& part : parts) {
    path += '/' + part;
  }
  return path;
}

std::optional<Target> parse_target(std::string_view target) {
  if (!target.starts_with('/')) {
    return std::nullopt;
  }
  const std::size_t question = std::min(target.find('?'), target.size());
  const std::string_view path = target.substr(1, question - 1);
  const std::string_view query = target.substr(std::min(question + 1, target.size()));
  Target parsed;
  const bool good =
      for_pieces(path, '/', [&](std::string_view piece) { return add_part(piece, parsed); }) &&
      for_pieces(query, '&', [&](std::string_view piece) { return add_field(piece, parsed); });
  return good ? std::optional(std::move(parsed)) : std::nullopt;
}

std::string lower_case(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return small;
}

std::string host_without_port(std::string_view host) {
  const std::size_t bracket = host.find(']');
  const std::size_t end =
      bracket != std::string_view::npos ? bracket + 1 : std::min(host.find(':'), host.size());
  const std::string_view port = host.substr(end);
  const bool is_port =
      port.empty() ||
      (port.front() == ':' && port.find_first_not_of("0123456789", 1) == std::string_view::npos);
  return lower_case(is_port ? host.substr(0, end) : host);
}

}  // namespace tacit::gateway
