#include "console/report/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace tacit {
namespace {

/// How many bytes the letter that begins with `byte` has; 0 when none begins so.
std::size_t letter_size(unsigned char byte) {
  if (byte < 0x80U) return 1;
  if (byte >= 0xc2U && byte < 0xe0U) return 2;
  if (byte >= 0xe0U && byte < 0xf0U) return 3;
  return byte >= 0xf0U && byte < 0xf5U ? 4 : 0;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = letter_size(static_cast<unsigned char>(text.front()));
    if (size == 0 || size > text.size()) return false;
    const auto follows = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
    if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size), follows)) {
      return false;
    }
    text.remove_prefix(size);
  }
  return true;
}

std::string escaped(char c, bool utf8) {
  constexpr std::array<std::pair<char, std::string_view>, 4> kNames{
      {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}}};
  const auto* name = std::find_if(kNames.begin(), kNames.end(),
                                  [c](const auto& known) { return known.first == c; });
  if (name != kNames.end()) return std::string(name->second);
  const auto byte = static_cast<unsigned char>(c);
  if (byte < 0x20U) return " ";
  return {byte >= 0x80U && !utf8 ? '?' : c};
}

}  // namespace

std::string svg_number(double value) {
  std::array<char, 400> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, 2)
                       .ptr;
  return {digits.data(), end};
}

std::string svg_escaped(std::string_view text) {
  const bool utf8 = is_utf8(text);
  std::string out;
  for (const char c : text) {
    out += escaped(c, utf8);
  }
  return out;
}

std::string svg_list(const std::vector<SvgPlace>& places) {
  std::string list;
  for (const SvgPlace& place : places) {
    list += (list.empty() ? "" : " ") + svg_number(place.x) + ',' + svg_number(place.y);
  }
  return list;
}

std::string svg_line(SvgPlace from, SvgPlace to, std::string_view style) {
  return "<line x1=\"" + svg_number(from.x) + "\" y1=\"" + svg_number(from.y) + "\" x2=\"" +
         svg_number(to.x) + "\" y2=\"" + svg_number(to.y) + "\" " + std::string(style) + "/>\n";
}

std::string svg_text(SvgPlace at, std::string_view text, std::string_view style) {
  return "<text x=\"" + svg_number(at.x) + "\" y=\"" + svg_number(at.y) + "\" " +
         std::string(style) + '>' + svg_escaped(text) + "</text>\n";
}

}  // namespace tacit
