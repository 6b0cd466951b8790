#include <array>
#include <cctype>
#include <utility>

#include "idl/cdl/parser.h"
#include "idl/types/nearest_word.h"

namespace tacit::cdl {
namespace {

/// What MissionLab's files begin statements with; any other inst… and def… is taken as well.
const std::array<std::string, 18> kKeywords{
    "bindArch",  "instAgent", "instGroup",   "instBP",   "instCoord", "instRobot",
    "instOp",    "defArch",   "defType",     "defAgent", "defOp",     "defCoordinator",
    "defSensor", "defIBP",    "defActuator", "defOBP",   "defRobot",  "defValue"};
constexpr std::size_t kLongestKeyword = 20;

bool begins(std::string_view word, std::string_view with) {
  return word.starts_with(with) && word.size() > with.size() &&
         std::isupper(static_cast<unsigned char>(word[with.size()])) != 0;
}

Statement::Kind kind_of(const Token& token) {
  if (token.kind != Token::Kind::Word) {
    return Statement::Kind::Configuration;
  }
  if (token.text == "bindArch") {
    return Statement::Kind::BindArchitecture;
  }
  if (begins(token.text, "inst")) {
    return Statement::Kind::Instantiation;
  }
  return begins(token.text, "def") ? Statement::Kind::Definition : Statement::Kind::Configuration;
}

int bracket(const Token& token) {
  const bool opens = token.is('(') || token.is('[');
  const bool closes = token.is(')') || token.is(']');
  return (opens ? 1 : 0) - (closes ? 1 : 0);
}

}  // namespace

Parsed Parser::run() {
  statements();
  parsed_.mission.closing_comments = take_comments();
  locate(parsed_.findings, text_);
  return std::move(parsed_);
}

void Parser::statements() {
  while (token_.kind != Token::Kind::End) {
    try {
      parsed_.mission.statements.push_back(statement());
    } catch (const Refusal& refusal) {
      parsed_.findings.push_back({Severity::Error, "syntax", refusal.text, refusal.offset, 0, 0});
      if (parsed_.findings.size() == kMostErrors) {
        parsed_.findings.push_back({Severity::Error, "syntax",
                                    "too many errors, the rest is not read", token_.begin, 0, 0});
        return;
      }
      recover();
    }
  }
}

void Parser::recover() {
  depth_ = 0;
  pending_.clear();
  bool ended = false;
  while (token_.kind != Token::Kind::End && !ended) {
    // The next statement, unless it is the one that failed.
    if (kind_of(token_) != Statement::Kind::Configuration && token_.begin > statement_begin_) {
      break;
    }
    ended = token_.is(';');
    advance();
  }
  comments_.clear();
}

Statement Parser::statement() {
  Statement made;
  made.comments = take_comments();
  made.kind = kind_of(token_);
  made.span.begin = statement_begin_ = token_.begin;
  switch (made.kind) {
    case Statement::Kind::BindArchitecture:
      bind_architecture(made);
      break;
    case Statement::Kind::Instantiation:
      instantiation(made);
      break;
    case Statement::Kind::Definition:
      definition(made);
      break;
    case Statement::Kind::Configuration:
      configuration(made);
      break;
  }
  end_of_statement(made);
  made.span.end = last_end_;
  return made;
}

void Parser::end_of_statement(const Statement& statement) {
  // The team is the last statement and needs no end.
  const bool last =
      statement.kind == Statement::Kind::Configuration &&
      (token_.kind == Token::Kind::End || kind_of(token_) != Statement::Kind::Configuration);
  if (!last) {
    expect(';', " at the end of the statement");
  } else {
    accept(';');
  }
}

void Parser::bind_architecture(Statement& statement) {
  statement.keyword = expect_word("bindArch");
  statement.name = expect_word("the name of an architecture, such as AuRA.urban");
}

void Parser::instantiation(Statement& statement) {
  statement.keyword = expect_word("a keyword");
  headings(statement.place, statement.description);
  statement.name = expect_word("the name of what is made");
  if (token_.text != "from") {
    refuse(found() + ", wanted \"from\" behind the name " + statement.name);
  }
  advance();
  statement.body = expression();
  if (statement.body.kind == Expression::Kind::Nothing) {
    refuse(found() + ", wanted what " + statement.name + " is made from");
  }
}

void Parser::definition(Statement& statement) {
  const std::uint32_t begin = token_.begin;
  statement.keyword = expect_word("a keyword");
  for (int depth = 0; !token_.is(';') || depth > 0; advance()) {
    comments_.clear();  // They are part of the text.
    if (token_.kind == Token::Kind::End || token_.kind == Token::Kind::Bad) {
      refuse(found() + ", wanted \";\" at the end of the definition");
    }
    depth += bracket(token_);
    if (statement.name.empty() && depth == 0 && token_.kind == Token::Kind::Word) {
      statement.name = token_.text;
    }
  }
  statement.text = text_.substr(begin, last_end_ - begin);
}

void Parser::configuration(Statement& statement) {
  const Token first = token_;
  const bool named = first.kind == Token::Kind::Word;
  statement.body = expression();
  const Expression::Kind kind = statement.body.kind;
  if (kind == Expression::Kind::Group || kind == Expression::Kind::Instance) {
    return;
  }
  const std::string word(first.text.substr(0, kLongestKeyword));
  const std::string hint = named ? did_you_mean(word, kKeywords) : "";
  throw Refusal{first.begin,
                found(first) + ", wanted a statement (bindArch, inst…, def…) or the team" + hint};
}

}  // namespace tacit::cdl
