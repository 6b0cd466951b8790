#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tacit {

/// On a picture: pixels to the right and down from its upper left corner.
struct SvgPlace {
  double x = 0.0;
  double y = 0.0;
};

/// With two decimals.
[[nodiscard]] std::string svg_number(double value);
/// `text` as SVG may hold it: markup named, control characters as blanks; when it is not UTF-8,
/// each byte above ASCII as a question mark.
[[nodiscard]] std::string svg_escaped(std::string_view text);
/// "x,y x,y".
[[nodiscard]] std::string svg_list(const std::vector<SvgPlace>& places);

/// Elements on lines of their own; `style` is written into them as it is.
[[nodiscard]] std::string svg_line(SvgPlace from, SvgPlace to, std::string_view style);
[[nodiscard]] std::string svg_text(SvgPlace at, std::string_view text, std::string_view style);

}  // namespace tacit
