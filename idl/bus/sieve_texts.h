#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "idl/bus/sieve.h"

namespace tacit {

/// Texts and lists whose lengths the wire does not bound.

inline constexpr std::size_t kShortText = 1000;
inline constexpr std::size_t kLongText = 10'000;
inline constexpr std::size_t kShortList = 1000;
inline constexpr std::size_t kLongList = 10'000;

inline std::string cut(const std::string& text, std::size_t limit) { return text.substr(0, limit); }

inline std::string sieve_text(Sieve& sieve, const std::string& text, std::size_t limit,
                              std::string_view what) {
  return sieve.pass(text.size() <= limit, what) ? text : std::string();
}

/// Each of at most `limit` items of `wire` through `convert`.
template <class To, class From, class Convert>
std::vector<To> sieve_list(Sieve& sieve, const std::vector<From>& wire, std::size_t limit,
                           std::string_view what, Convert convert) {
  std::vector<To> out;
  if (!sieve.pass(wire.size() <= limit, what)) return out;
  out.reserve(wire.size());
  for (const From& item : wire) out.push_back(convert(item));
  return out;
}

/// The first `limit` items of `list` through `convert`.
template <class To, class From, class Convert>
std::vector<To> cut_list(const std::vector<From>& list, std::size_t limit, Convert convert) {
  std::vector<To> out(std::min(list.size(), limit));
  for (std::size_t i = 0; i < out.size(); ++i) convert(list[i], out[i]);
  return out;
}

inline std::vector<std::string> sieve_texts(Sieve& sieve, const std::vector<std::string>& wire,
                                            std::string_view what) {
  return sieve_list<std::string>(sieve, wire, kShortList, what, [&](const std::string& text) {
    return sieve_text(sieve, text, kShortText, what);
  });
}

inline std::vector<std::string> cut_texts(const std::vector<std::string>& list) {
  return cut_list<std::string>(list, kShortList, [](const std::string& from, std::string& to) {
    to = cut(from, kShortText);
  });
}

}  // namespace tacit
