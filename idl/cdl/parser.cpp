#include "idl/cdl/parser.h"

#include <cctype>
#include <iterator>
#include <limits>
#include <utility>

namespace tacit::cdl {
namespace {

constexpr std::size_t kMostQuoted = 40;

}  // namespace

Parsed parse(std::string_view text) {
  if (text.size() >= std::numeric_limits<std::uint32_t>::max()) {
    Parsed refused;
    refused.findings.push_back({Severity::Error, "syntax", "the file has 4 GiB or more", 0, 1, 1});
    return refused;
  }
  return Parser(text).run();
}

Parser::Parser(std::string_view text) : text_(text), lexer_(text) { advance(); }

void Parser::advance() {
  last_end_ = token_.end;
  token_ = lexer_.next();
  for (std::string& comment : lexer_.comments()) {
    comments_.push_back(std::move(comment));
  }
  lexer_.comments().clear();
}

Comments Parser::take_comments() { return std::exchange(comments_, {}); }

bool Parser::accept(char symbol) {
  if (!token_.is(symbol)) {
    return false;
  }
  advance();
  return true;
}

void Parser::expect(char symbol, std::string_view hint) {
  if (!accept(symbol)) {
    refuse(found() + ", wanted \"" + symbol + '"' + std::string(hint));
  }
}

std::string Parser::expect_word(std::string_view wanted) {
  if (token_.kind != Token::Kind::Word) {
    refuse(found() + ", wanted " + std::string(wanted));
  }
  std::string word(token_.text);
  advance();
  return word;
}

std::string Parser::found(const Token& token) {
  if (token.kind == Token::Kind::End) {
    return "found the end of the file";
  }
  if (token.kind == Token::Kind::Bad) {
    return "found " + describe_bad(token.text);
  }
  std::string shown(token.text.substr(0, kMostQuoted));
  for (char& letter : shown) {
    letter = std::isprint(static_cast<unsigned char>(letter)) != 0 ? letter : '?';
  }
  return "found \"" + shown + (token.text.size() > kMostQuoted ? "…\"" : "\"");
}

void Parser::refuse(const std::string& text) const {
  throw Refusal{token_.begin,
                token_.kind == Token::Kind::Bad ? "found " + describe_bad(token_.text) : text};
}

Expression Parser::expression() {
  const std::uint32_t begin = token_.begin;
  Expression made;
  if (token_.kind == Token::Kind::Word) {
    std::string word = expect_word("a name");
    return word == "if" ? rule(begin) : named(std::move(word), begin);
  }
  if (token_.kind == Token::Kind::Value) {
    made.kind = Expression::Kind::Value;
    made.name = token_.text.substr(1, token_.text.size() - 2);
    advance();
  } else if (token_.is('[')) {
    made.kind = Expression::Kind::Group;
    list(made, '[', ']');
  } else {
    made.span = {last_end_, last_end_};
    return made;
  }
  tail(made);
  made.span = {begin, last_end_};
  return made;
}

Expression Parser::named(std::string word, std::uint32_t begin) {
  Expression made;
  made.kind = Expression::Kind::Reference;
  while (accept(':')) {
    made.labels.push_back(std::move(word));
    if (token_.is('[')) {
      made.kind = Expression::Kind::Group;
      list(made, '[', ']');
      break;
    }
    word = expect_word("a type or \"[\" behind \":\"");
  }
  if (made.kind != Expression::Kind::Group) {
    made.name = std::move(word);
    if (token_.is('(')) {
      made.kind = Expression::Kind::Instance;
      list(made, '(', ')');
    } else if (!made.labels.empty()) {
      refuse(found() + ", wanted \"(\" behind the type " + made.name);
    }
  }
  tail(made);
  made.span = {begin, last_end_};
  return made;
}

Expression Parser::rule(std::uint32_t begin) {
  deeper(begin);
  Expression made;
  made.kind = Expression::Kind::Rule;
  Item condition;
  condition.comments = take_comments();
  condition.span.begin = token_.begin;
  condition.value = expression();
  if (condition.value.kind == Expression::Kind::Nothing) {
    refuse(found() + ", wanted a condition: if [ … ] goto STATE");
  }
  condition.span.end = last_end_;
  made.items.push_back(std::move(condition));
  if (token_.text != "goto") {
    refuse(found() + ", wanted \"goto\" behind the condition");
  }
  advance();
  made.name = expect_word("the name of a state behind \"goto\"");
  --depth_;
  made.span = {begin, last_end_};
  return made;
}

void Parser::list(Expression& owner, char opening, char closing) {
  deeper(token_.begin);
  expect(opening);
  const std::size_t first = pending_.size();
  while (!token_.is(closing)) {
    pending_.push_back(item());
    if (token_.is(closing)) {
      break;
    }
    if (!accept(',')) {
      refuse(found() + ", wanted \",\" or \"" + closing + '"');
    }
  }
  owner.items = taken_from(first);
  owner.closing_comments = take_comments();
  advance();
  --depth_;
}

std::vector<Item> Parser::taken_from(std::size_t first) {
  const auto begin = pending_.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<Item> taken(std::make_move_iterator(begin), std::make_move_iterator(pending_.end()));
  pending_.erase(begin, pending_.end());
  return taken;
}

void Parser::deeper(std::uint32_t begin) {
  if (++depth_ > kDeepest) {
    throw Refusal{begin, "lists and rules in each other, more than " + std::to_string(kDeepest) +
                             " deep, wanted fewer"};
  }
}

Item Parser::item() {
  Item made;
  made.comments = take_comments();
  made.span.begin = token_.begin;
  const bool is_parameter = token_.kind == Token::Kind::Parameter;
  const bool is_named = token_.kind == Token::Kind::Word && token_.text != "if";
  if (!is_named && !is_parameter) {
    made.value = expression();
    if (made.value.kind == Expression::Kind::Nothing) {
      refuse(found() + ", wanted a name, a value, \"[\" or \"name = …\"");
    }
    made.span.end = last_end_;
    return made;
  }
  std::string word(token_.text.substr(is_parameter ? 1 : 0));
  advance();
  Slot slot;
  slot.index = index();
  headings(slot.place, slot.description);
  if (accept('=')) {
    slot.name = std::move(word);
    slot.is_parameter = is_parameter;
    made.slot = std::move(slot);
    made.value = expression();
  } else if (is_parameter || slot.index) {
    refuse(found() + ", wanted \"=\" behind " + word);
  } else if (slot.place || slot.description) {
    made.value.kind = Expression::Kind::Reference;
    made.value.name = std::move(word);
    made.value.place = slot.place;
    made.value.description = std::move(slot.description);
    made.value.span = {made.span.begin, last_end_};
  } else {
    made.value = named(std::move(word), made.span.begin);
  }
  made.span.end = last_end_;
  return made;
}

std::optional<std::string> Parser::index() {
  if (!accept('[')) {
    return std::nullopt;
  }
  std::string word = expect_word("a name between \"[\" and \"]\"");
  expect(']');
  return word;
}

void Parser::headings(std::optional<Place>& place, std::optional<std::string>& description) {
  if (token_.kind == Token::Kind::Place) {
    place = place_of(token_.text);
    advance();
  }
  if (token_.kind == Token::Kind::Description) {
    description = token_.text.substr(1, token_.text.size() - 2);
    advance();
  }
}

void Parser::tail(Expression& expression) { headings(expression.place, expression.description); }

}  // namespace tacit::cdl
