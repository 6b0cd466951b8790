#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "idl/cdl/lexer.h"
#include "idl/cdl/parse.h"

namespace tacit::cdl {

/// Reads statements by recursive descent. Used once.
class Parser {
 public:
  explicit Parser(std::string_view text);
  [[nodiscard]] Parsed run();

 private:
  /// Why the statement at hand is given up.
  struct Refusal {
    std::uint32_t offset;
    std::string text;
  };

  void statements();
  Statement statement();
  void bind_architecture(Statement& statement);
  void instantiation(Statement& statement);
  void definition(Statement& statement);
  void configuration(Statement& statement);
  void end_of_statement(const Statement& statement);
  void recover();

  Expression expression();
  Expression named(std::string word, std::uint32_t begin);
  Expression rule(std::uint32_t begin);
  void list(Expression& owner, char opening, char closing);
  std::vector<Item> taken_from(std::size_t first);
  void deeper(std::uint32_t begin);
  Item item();
  void tail(Expression& expression);
  void headings(std::optional<Place>& place, std::optional<std::string>& description);
  std::optional<std::string> index();

  void advance();
  bool accept(char symbol);
  void expect(char symbol, std::string_view hint = "");
  std::string expect_word(std::string_view wanted);
  Comments take_comments();
  [[nodiscard]] std::string found() const { return found(token_); }
  [[nodiscard]] static std::string found(const Token& token);
  [[noreturn]] void refuse(const std::string& text) const;

  std::string_view text_;
  Lexer lexer_;
  Token token_;
  std::uint32_t last_end_ = 0;
  std::uint32_t statement_begin_ = 0;
  int depth_ = 0;
  std::vector<Item>
      pending_;        ///< Of the lists at hand; so each gets memory once, as much as it needs.
  Comments comments_;  ///< Before the token at hand, not yet taken.
  Parsed parsed_;
};

}  // namespace tacit::cdl
