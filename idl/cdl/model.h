#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tacit::cdl {

/// Bytes [begin, end) of the text that something was read from; empty when it was not read. Says
/// where, not what: any two are equal.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) { return true; }
};

/// Where the graphical editor draws something, in its pixels: `<x,y>`.
struct Place {
  double x = 0.0;
  double y = 0.0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// With their signs, without the line's end.
using Comments = std::vector<std::string>;

struct Item;

/// What stands for something: behind `=`, behind `from`, in a list.
struct Expression {
  enum class Kind {
    Nothing,    ///< A place without a connection: `v<0,0> = ,`.
    Reference,  ///< A name.
    Value,      ///< `{text}`; `name` holds what stands between the braces, unchanged.
    Instance,   ///< `label:TYPE(items)`; `name` is the type.
    Group,      ///< `label:[items]`.
    Rule,       ///< `if condition goto name`; the condition is the only item.
  };
  Kind kind = Kind::Nothing;
  std::vector<std::string> labels;  ///< Of an instance or group.
  std::string name;
  std::vector<Item> items;
  std::optional<Place> place;
  std::optional<std::string> description;  ///< Without its bars.
  Comments closing_comments;               ///< Behind the last item.
  Span span{};
  friend bool operator==(const Expression&, const Expression&) = default;
};

/// What an item of a list is connected to: `name[index]<x,y>|description| =`.
struct Slot {
  std::string name;                  ///< Without the `%`.
  bool is_parameter = false;         ///< Written `%name`: offered to what is inside.
  std::optional<std::string> index;  ///< The state of `rules[state]`.
  std::optional<Place> place;
  std::optional<std::string> description;
  friend bool operator==(const Slot&, const Slot&) = default;
};

/// One of a list.
struct Item {
  Comments comments;  ///< Before it.
  std::optional<Slot> slot;
  Expression value;
  Span span{};  ///< Without the comments.
  friend bool operator==(const Item&, const Item&) = default;
};

/// One of the file's statements.
struct Statement {
  enum class Kind {
    BindArchitecture,  ///< `bindArch name;`
    Instantiation,     ///< `instBP<x,y> |description| name from body;`
    Definition,        ///< `defOp name …;` of a library; kept as text.
    Configuration,     ///< The team itself: the body alone.
  };
  Kind kind = Kind::Configuration;
  Comments comments;
  std::string keyword;  ///< `bindArch`, `instBP`, `defOp`, …; none for the team.
  std::string name;
  std::optional<Place> place;
  std::optional<std::string> description;
  Expression body;
  std::string text;  ///< Of a definition: all from keyword to the letter before `;`.
  Span span{};       ///< Without the comments.
  friend bool operator==(const Statement&, const Statement&) = default;
};

/// A file of the Configuration Description Language.
struct Mission {
  std::vector<Statement> statements;
  Comments closing_comments;  ///< Behind the last statement.
  friend bool operator==(const Mission&, const Mission&) = default;
};

}  // namespace tacit::cdl
