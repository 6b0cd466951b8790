#include "idl/overlay/tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tacit {
namespace {

bool parts(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\f' || c == '\v' || c == '\n';
}

bool begins_comment(std::string_view text, std::size_t at, std::size_t end) {
  return at + 1 < end && text[at] == '-' && text[at + 1] == '-';
}

std::size_t end_of_word(std::string_view text, std::size_t at, std::size_t end) {
  while (at < end && !parts(text[at]) && text[at] != '"' && !begins_comment(text, at, end)) {
    ++at;
  }
  return at;
}

MapToken word(std::string_view text, std::size_t begin, std::size_t end) {
  MapToken token;
  token.text = text.substr(begin, end - begin);
  if (const std::optional<double> number = map_number(token.text)) {
    token.kind = MapToken::Kind::Number;
    token.number = *number;
  }
  return token;
}

constexpr std::size_t kLongest = 60;

}  // namespace

MapRefusal refusal(const MapToken& token, std::string_view wanted) {
  std::string found(token.text.substr(0, kLongest));
  found = token.text.size() > kLongest ? found + "..." : found;
  if (token.kind != MapToken::Kind::Number) {
    found = '"' + found + '"';
  }
  return {{Severity::Error, token.at, "found " + found + ", wanted " + std::string(wanted)}};
}

std::optional<MapSpot> add_tokens(std::string_view text, std::size_t begin, std::size_t end,
                                  std::uint32_t line, std::vector<MapToken>& tokens) {
  std::size_t at = begin;
  std::optional<MapSpot> open_quote;
  while (at < end && !begins_comment(text, at, end)) {
    if (parts(text[at])) {
      ++at;
      continue;
    }
    const MapSpot spot{line, static_cast<std::uint32_t>(at - begin + 1)};
    MapToken token;
    std::size_t after = 0;
    if (text[at] == '"') {
      const std::size_t close = std::min(text.find('"', at + 1), end);
      token.kind = MapToken::Kind::Quoted;
      token.text = text.substr(at + 1, close - at - 1);
      open_quote = close == end ? std::optional(spot) : open_quote;
      after = std::min(close + 1, end);
    } else {
      after = end_of_word(text, at, end);
      token = word(text, at, after);
    }
    token.at = spot;
    token.begin = at;
    token.end = after;
    tokens.push_back(token);
    at = after;
  }
  return open_quote;
}

std::string capitals(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return out;
}

std::optional<double> map_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  const std::size_t first = text.find_first_not_of('-');
  if (first == std::string_view::npos || text[first] > '9') {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace tacit
