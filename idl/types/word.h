#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tacit {

/// A short text that robots signal and operators read: at most 63 printable ASCII characters.
class Word {
 public:
  static constexpr std::size_t kMaxLength = 63;

  Word() = default;
  /// `fits(text)`.
  explicit Word(std::string_view text) : length_(static_cast<std::uint8_t>(text.size())) {
    assert(fits(text));
    std::copy(text.begin(), text.end(), letters_.begin());
  }

  [[nodiscard]] static bool fits(std::string_view text) {
    return text.size() <= kMaxLength &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  }
  [[nodiscard]] std::string_view text() const { return {letters_.data(), length_}; }
  [[nodiscard]] bool empty() const { return length_ == 0; }
  friend bool operator==(const Word& a, const Word& b) { return a.text() == b.text(); }

 private:
  std::array<char, kMaxLength> letters_{};
  std::uint8_t length_ = 0;
};

}  // namespace tacit
