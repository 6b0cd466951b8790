#pragma once

#include <cstddef>
#include <variant>

namespace tacit {

/// A list of types, as a value.
template <class... Types>
struct TypeList {
  static constexpr std::size_t kSize = sizeof...(Types);
  using Variant = std::variant<Types...>;
};

}  // namespace tacit
