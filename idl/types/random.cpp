#include "idl/types/random.h"

#include "idl/types/elementary.h"

namespace tacit {
namespace {

PhiloxBlock philox_round(const PhiloxBlock& c, std::uint32_t k0, std::uint32_t k1) {
  const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0];
  const std::uint64_t b = std::uint64_t{0xCD9E8D57} * c[2];
  return {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ k0, static_cast<std::uint32_t>(b),
          static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ k1, static_cast<std::uint32_t>(a)};
}

// FNV-1a, to turn a purpose into a number.
std::uint64_t name_hash(std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
  }
  return hash;
}

std::uint64_t first_half(const PhiloxBlock& block) {
  return (std::uint64_t{block[1]} << 32) | block[0];
}

}  // namespace

PhiloxBlock philox(PhiloxBlock counter, std::uint64_t key) {
  auto k0 = static_cast<std::uint32_t>(key);
  auto k1 = static_cast<std::uint32_t>(key >> 32);
  for (int round = 0; round < 10; ++round) {
    counter = philox_round(counter, k0, k1);
    k0 += 0x9E3779B9;
    k1 += 0xBB67AE85;
  }
  return counter;
}

Stream::Stream(std::uint64_t seed, std::string_view purpose, std::uint64_t owner)
    : key_(first_half(
          philox({static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), 0, 0},
                 name_hash(purpose)))),
      owner_(owner) {}

std::uint64_t Stream::bits() {
  const std::uint64_t n = position_++;
  return first_half(
      philox({static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n >> 32),
              static_cast<std::uint32_t>(owner_), static_cast<std::uint32_t>(owner_ >> 32)},
             key_));
}

double Stream::uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

double Stream::uniform(double low, double high) { return low + (high - low) * uniform(); }

std::uint64_t Stream::below(std::uint64_t count) {
  // The bias is below count / 2^53.
  return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
}

double Stream::normal() {
  const double radius = std::sqrt(-2.0 * natural_log(1.0 - uniform()));
  return radius * sin_cos(2.0 * kPi * uniform()).cos;
}

}  // namespace tacit
