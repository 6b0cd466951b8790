#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tacit {

/// What an IDL text holds that the schemas cannot say; the message names file and line.
class IdlError : public std::runtime_error {
 public:
  IdlError(const std::string& file, std::size_t line, const std::string& what)
      : std::runtime_error(file + ':' + std::to_string(line) + ": " + what) {}
};

/// One member of a struct: of a basic type, a text, or a struct that stands before.
struct IdlMember {
  /// How many there are of it.
  enum class Many { One, Array, Sequence };

  std::string type;  ///< "double", "unsigned long long", "string", or a struct's own name.
  std::string name;
  std::optional<std::size_t> text_bound;  ///< N of string<N>.
  Many many = Many::One;
  std::optional<std::size_t> count;  ///< Of an array, all dimensions; N of sequence<T, N>.
};

struct IdlStruct {
  std::string scope;  ///< "tacit::wire"; empty outside every module.
  std::string name;
  std::vector<IdlMember> members;
};

/// Whether `type` is one of IDL's basic types or a string.
[[nodiscard]] bool is_basic(std::string_view type);

/// Reads the part of IDL that Tacit's wire types are written in: comments, modules, structs, the
/// basic types, string<N>, sequence<T, N> and arrays. Structs in their order. Throws IdlError for
/// anything else, naming `file`.
[[nodiscard]] std::vector<IdlStruct> parse_idl(std::string_view text, const std::string& file);

}  // namespace tacit
