#include "idl/schema/idl_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace tacit {
namespace {

constexpr std::array<std::string_view, 12> kBasic{
    "boolean",       "octet",     "char",  "short",  "unsigned short", "long",
    "unsigned long", "long long", "float", "double", "string",         "unsigned long long"};

bool is_word_char(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

struct Token {
  std::string_view text;
  std::size_t line = 0;
};

/// A text as words and single signs, without comments.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<Token> tokens() {
    std::vector<Token> tokens;
    for (skip_space(); at_ < text_.size(); skip_space()) {
      const std::size_t begin = at_;
      at_ += 1;
      if (is_word_char(text_[begin])) {
        while (at_ < text_.size() && is_word_char(text_[at_])) ++at_;
      }
      tokens.push_back({text_.substr(begin, at_ - begin), line_});
    }
    return tokens;
  }

 private:
  void skip_space() {
    while (at_ < text_.size()) {
      if (text_.substr(at_).starts_with("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_).starts_with("/*")) {
        skip_comment();
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        line_ += text_[at_++] == '\n' ? 1 : 0;
      } else {
        return;
      }
    }
  }

  void skip_comment() {
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) throw IdlError(file_, line_, "the comment has no end");
    line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(end),
                                                 '\n'));
    at_ = end + 2;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

class Parser {
 public:
  Parser(std::string_view text, std::string file)
      : file_(std::move(file)), tokens_(Scanner(text, file_).tokens()) {
    tokens_.push_back({"", tokens_.empty() ? 1 : tokens_.back().line});
  }

  std::vector<IdlStruct> structs() {
    while (!next().empty()) definition("");
    return std::move(structs_);
  }

 private:
  [[nodiscard]] std::string_view next() const { return tokens_[at_].text; }

  [[noreturn]] void refuse(const std::string& wanted) const {
    throw IdlError(file_, tokens_[at_].line,
                   "found " + (next().empty() ? "the end" : '"' + std::string(next()) + '"') +
                       ", wanted " + wanted);
  }

  bool take_if(std::string_view text) {
    if (next() != text) return false;
    ++at_;
    return true;
  }
  void take(std::string_view text) {
    if (!take_if(text)) refuse('"' + std::string(text) + '"');
  }
  std::string take_name() {
    if (next().empty() || !is_word_char(next().front())) refuse("a name");
    return std::string(tokens_[at_++].text);
  }
  std::size_t take_number() {
    std::size_t number = 0;
    const std::string_view text = next();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number == 0) {
      refuse("a number above 0");
    }
    ++at_;
    return number;
  }

  void definition(const std::string& scope) {
    if (take_if("module")) {
      module(scope);
    } else if (take_if("struct")) {
      structure(scope);
    } else {
      refuse("module or struct");
    }
  }

  void module(const std::string& scope) {
    const std::string inner = scope + (scope.empty() ? "" : "::") + take_name();
    take("{");
    while (!take_if("}")) definition(inner);
    take(";");
  }

  void structure(const std::string& scope) {
    IdlStruct made{scope, take_name(), {}};
    take("{");
    while (!take_if("}")) made.members.push_back(member());
    take(";");
    structs_.push_back(std::move(made));
  }

  IdlMember member() {
    IdlMember made;
    if (take_if("sequence")) {
      sequence(made);
    } else {
      type(made);
    }
    made.name = take_name();
    while (take_if("[")) dimension(made);
    take(";");
    return made;
  }

  void sequence(IdlMember& made) {
    made.many = IdlMember::Many::Sequence;
    take("<");
    type(made);
    if (take_if(",")) made.count = take_number();
    take(">");
  }

  void dimension(IdlMember& made) {
    if (made.many == IdlMember::Many::Sequence) refuse("no array of sequences");
    made.many = IdlMember::Many::Array;
    made.count = made.count.value_or(1) * take_number();
    take("]");
  }

  void type(IdlMember& made) {
    const std::size_t begin = at_;
    made.type = take_name();
    if (made.type == "unsigned") made.type += ' ' + take_name();
    if (made.type.ends_with("long") && take_if("long")) made.type += " long";
    if (made.type == "string" && take_if("<")) {
      made.text_bound = take_number();
      take(">");
    }
    if (!is_basic(made.type) && !is_known(made.type)) {
      at_ = begin;
      refuse("a basic type, string, sequence or a struct that stands before");
    }
  }

  [[nodiscard]] bool is_known(const std::string& name) const {
    return std::any_of(structs_.begin(), structs_.end(),
                       [&](const IdlStruct& each) { return each.name == name; });
  }

  std::string file_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<IdlStruct> structs_;
};

}  // namespace

bool is_basic(std::string_view type) {
  return std::find(kBasic.begin(), kBasic.end(), type) != kBasic.end();
}

std::vector<IdlStruct> parse_idl(std::string_view text, const std::string& file) {
  return Parser(text, file).structs();
}

}  // namespace tacit
