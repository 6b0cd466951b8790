#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tacit::mcap {

using Bytes = std::vector<std::uint8_t>;
using Span = std::span<const std::uint8_t>;
using Texts = std::map<std::string, std::string>;

static_assert(std::endian::native == std::endian::little, "MCAP is little-endian, as we are");

/// Appends what MCAP's records are made of.
class ByteWriter {
 public:
  explicit ByteWriter(Bytes& out) : out_(out) {}

  template <class Number>
  ByteWriter& number(Number value) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&value);
    out_.insert(out_.end(), bytes, bytes + sizeof value);
    return *this;
  }
  ByteWriter& bytes(Span bytes) {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  /// With its length before it.
  ByteWriter& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    out_.insert(out_.end(), text.begin(), text.end());
    return *this;
  }
  ByteWriter& texts(const Texts& texts) {
    const std::size_t begin = out_.size();
    number(std::uint32_t{0});
    for (const auto& [key, value] : texts) text(key).text(value);
    const auto length = static_cast<std::uint32_t>(out_.size() - begin - sizeof(std::uint32_t));
    std::memcpy(out_.data() + begin, &length, sizeof length);
    return *this;
  }

 private:
  Bytes& out_;
};

/// Bytes that end before what they should hold.
class TooShort : public std::runtime_error {
 public:
  TooShort() : std::runtime_error("a record is shorter than what it should hold") {}
};

/// Takes them apart again. Throws TooShort and reads nothing outside its bytes.
class ByteReader {
 public:
  explicit ByteReader(Span bytes) : rest_(bytes) {}

  template <class Number>
  Number number() {
    Number value{};
    const Span taken = take(sizeof value);
    std::memcpy(&value, taken.data(), sizeof value);
    return value;
  }
  Span take(std::uint64_t size) {
    if (size > rest_.size()) throw TooShort();
    const Span taken = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return taken;
  }
  /// As many bytes as the number before them says.
  template <class Length>
  Span sized() {
    return take(number<Length>());
  }
  std::string text() {
    const Span taken = sized<std::uint32_t>();
    return {taken.begin(), taken.end()};
  }
  Texts texts() {
    Texts texts;
    for (ByteReader inner(sized<std::uint32_t>()); !inner.done();) {
      std::string key = inner.text();
      texts[std::move(key)] = inner.text();
    }
    return texts;
  }
  [[nodiscard]] bool done() const { return rest_.empty(); }
  [[nodiscard]] Span rest() const { return rest_; }

 private:
  Span rest_;
};

}  // namespace tacit::mcap
