#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "idl/cdl/model.h"

namespace tacit::cdl {

struct Token {
  enum class Kind {
    Word,         ///< `Start`, `$AN_12`, `AuRA.urban`, `SurveyRoom*`, `10`.
    Parameter,    ///< `%name`.
    Place,        ///< `<x,y>`.
    Value,        ///< `{…}`.
    Description,  ///< `|…|`.
    Text,         ///< `"…"` outside a value; only definitions have it.
    Symbol,       ///< One letter with a meaning, or one that only definitions have.
    Bad,          ///< Nothing of the language.
    End,
  };
  Kind kind = Kind::End;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string_view text;

  [[nodiscard]] bool is(char symbol) const { return kind == Kind::Symbol && text[0] == symbol; }
};

/// Cuts a text into tokens, from the front. The text outlives it and has less than 4 GiB.
class Lexer {
 public:
  explicit Lexer(std::string_view text);
  ~Lexer();

  /// The next one; End again and again when there is none. Takes time for each byte once.
  [[nodiscard]] Token next();

  /// The comments passed since they were last taken.
  [[nodiscard]] Comments& comments() { return comments_; }

 private:
  struct Input;
  Token bad_token();

  std::unique_ptr<Input> input_;
  Comments comments_;
};

/// What the text of a bad token is, in words.
[[nodiscard]] std::string describe_bad(std::string_view text);

/// Of a Place token.
[[nodiscard]] Place place_of(std::string_view text);

}  // namespace tacit::cdl
