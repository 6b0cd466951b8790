#include "idl/cdl/label.h"

namespace tacit::cdl {
namespace {

constexpr std::size_t kLongestLabel = 80;

/// Bytes of a letter of UTF-8 by its first; 0 when none begins so.
std::size_t length_by_lead(unsigned char lead) {
  return lead < 0x80   ? 1
         : lead < 0xC2 ? 0
         : lead < 0xE0 ? 2
         : lead < 0xF0 ? 3
         : lead < 0xF5 ? 4
                       : 0;
}

/// Overlong forms, surrogates and what lies beyond Unicode.
bool is_forbidden(unsigned char lead, unsigned char second) {
  return (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
         (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
}

/// Bytes of the UTF-8 letter that `text` begins with; 0 when it begins with none.
std::size_t letter_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = length_by_lead(byte(0));
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= text.size() || (byte(i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  return length > 1 && is_forbidden(byte(0), byte(1)) ? 0 : length;
}

bool is_control(unsigned char byte) { return byte < 0x20 || (byte >= 0x7F && byte < 0xA0); }

std::string latin1_letter(unsigned char byte) {
  return is_control(byte) ? " "
                          : std::string{static_cast<char>(0xC0U | (byte >> 6U)),
                                        static_cast<char>(0x80U | (byte & 0x3FU))};
}

/// The letters U+0080 to U+009F are controls as well.
std::string shown(std::string_view letter) {
  const auto last = static_cast<unsigned char>(letter.back());
  const bool control = letter.size() == 1 ? is_control(last) : letter[0] == '\xC2' && last < 0xA0;
  return control ? " " : std::string(letter);
}

}  // namespace

std::string label_of(std::string_view text) {
  std::string made;
  while (!text.empty() && made.size() < kLongestLabel) {
    const std::size_t length = letter_length(text);
    made += length == 0 ? latin1_letter(static_cast<unsigned char>(text[0]))
                        : shown(text.substr(0, length));
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return made + (text.empty() ? "" : "…");
}

}  // namespace tacit::cdl
