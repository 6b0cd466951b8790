#include "idl/cdl/lexer.h"

#include <algorithm>
#include <charconv>
#include <tao/pegtl.hpp>

namespace tacit::cdl {
namespace {

namespace peg = tao::pegtl;

// Every rule stops at a NUL byte, so that none is taken for a part of a mission.
struct letter : peg::sor<peg::alnum, peg::one<'_', '$'>> {};
struct word_rest : peg::sor<letter, peg::one<'.', '*', '-', '+'>> {};
struct word : peg::seq<peg::sor<letter, peg::one<'-', '+', '.'>>, peg::star<word_rest>> {};
struct parameter : peg::seq<peg::one<'%'>, letter, peg::star<word_rest>> {};

struct quoted : peg::sor<peg::seq<peg::one<'\\'>, peg::not_one<'\0', '\n'>>,
                         peg::not_one<'"', '\\', '\n', '\0'>> {};
struct text : peg::seq<peg::one<'"'>, peg::star<quoted>, peg::one<'"'>> {};
struct braced : peg::sor<peg::not_one<'{', '}', '"', '\0'>, text> {};
struct value : peg::seq<peg::one<'{'>, peg::star<braced>, peg::one<'}'>> {};
struct description : peg::seq<peg::one<'|'>, peg::star<peg::not_one<'|', '\0'>>, peg::one<'|'>> {};

struct blanks : peg::star<peg::space> {};
struct fraction : peg::seq<peg::one<'.'>, peg::plus<peg::digit>> {};
struct number : peg::seq<peg::opt<peg::one<'-', '+'>>, peg::rep_min_max<1, 15, peg::digit>,
                         peg::opt<fraction>> {};
struct place : peg::seq<peg::one<'<'>, blanks, number, blanks, peg::one<','>, blanks, number,
                        blanks, peg::one<'>'>> {};

struct line_comment : peg::seq<peg::string<'/', '/'>, peg::star<peg::not_one<'\n', '\0'>>> {};
struct block_comment
    : peg::seq<peg::string<'/', '*'>, peg::until<peg::string<'*', '/'>, peg::not_one<'\0'>>> {};
struct comment : peg::sor<line_comment, block_comment> {};
struct between : peg::star<peg::sor<peg::plus<peg::space>, comment>> {};

struct symbol : peg::one<'[', ']', '(', ')', '=', ',', ';', ':'> {};
/// Letters without a meaning in a mission; the definitions of a library may hold them.
struct other
    : peg::one<'<', '>', '!', '#', '&', '\'', '/', '?', '@', '\\', '^', '`', '~', '%', '*'> {};
struct comment_begin : peg::string<'/', '*'> {};
struct any_symbol : peg::seq<peg::not_at<comment_begin>, peg::sor<symbol, other>> {};
struct token : peg::sor<word, symbol, value, place, description, parameter, text, any_symbol> {};

template <typename Rule>
struct take : peg::nothing<Rule> {};
template <Token::Kind kind>
struct take_as {
  static void apply0(Token& found) { found.kind = kind; }
};
template <>
struct take<word> : take_as<Token::Kind::Word> {};
template <>
struct take<parameter> : take_as<Token::Kind::Parameter> {};
template <>
struct take<place> : take_as<Token::Kind::Place> {};
template <>
struct take<text> : take_as<Token::Kind::Text> {};
template <>
struct take<value> : take_as<Token::Kind::Value> {};
template <>
struct take<description> : take_as<Token::Kind::Description> {};
template <>
struct take<symbol> : take_as<Token::Kind::Symbol> {};
template <>
struct take<any_symbol> : take_as<Token::Kind::Symbol> {};

template <typename Rule>
struct keep : peg::nothing<Rule> {};
template <>
struct keep<comment> {
  template <typename Found>
  static void apply(const Found& found, Comments& comments) {
    comments.push_back(found.string());
  }
};

}  // namespace

struct Lexer::Input {
  std::string_view text;
  peg::memory_input<peg::tracking_mode::lazy, peg::eol::lf, const char*> in;

  [[nodiscard]] std::uint32_t offset() const {
    return static_cast<std::uint32_t>(in.current() - text.data());
  }
};

Lexer::Lexer(std::string_view text)
    : input_(new Input{text, {text.data(), text.data() + text.size(), ""}}) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) {
    input_->in.bump(kByteOrderMark.size());
  }
}

Lexer::~Lexer() = default;

Token Lexer::next() {
  peg::parse<between, keep>(input_->in, comments_);
  Token found;
  found.begin = found.end = input_->offset();
  if (input_->in.empty()) {
    return found;
  }
  if (!peg::parse<token, take>(input_->in, found)) {
    return bad_token();
  }
  found.end = input_->offset();
  found.text = input_->text.substr(found.begin, found.end - found.begin);
  return found;
}

Token Lexer::bad_token() {
  const std::uint32_t begin = input_->offset();
  std::string_view rest = input_->text.substr(begin);
  std::size_t length = 1;
  if (rest.starts_with("/*")) {
    // To where the search for its end gave up, so that no byte is searched twice.
    length = std::min(rest.find('\0'), rest.size());
  }
  rest = rest.substr(0, length);
  input_->in.bump(length);
  return {Token::Kind::Bad, begin, input_->offset(), rest};
}

std::string describe_bad(std::string_view bad) {
  const auto byte = static_cast<unsigned char>(bad[0]);
  if (bad.starts_with("/*")) {
    return "a comment without its end, wanted \"*/\"";
  }
  switch (bad[0]) {
    case '\0':
      return "a NUL byte";
    case '{':
      return "a value without its end, wanted \"}\"";
    case '|':
      return "a description without its end, wanted a second \"|\"";
    case '"':
      return "a text without its end, wanted a second quotation mark in the line";
    case '}':
      return "\"}\" without \"{\"";
    default:
      return "the byte " + std::to_string(byte) +
             ", which only descriptions, comments and values may hold";
  }
}

namespace {

double number_of(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\v\f+"), text.size()));
  double number = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

Place place_of(std::string_view text) {
  const std::size_t comma = text.find(',');
  return {number_of(text.substr(1, comma - 1)), number_of(text.substr(comma + 1))};
}

}  // namespace tacit::cdl
