#include "idl/cdl/printer.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"

namespace tacit::cdl {
namespace {

bool same_place(const Span& a, const Span& b) { return a.begin == b.begin && a.end == b.end; }

/// The part of `origins` that `part` was read from, or null.
template <typename Part>
const Part* origin_of(const Part& part, const std::vector<Part>& origins) {
  if (part.span.end == 0) {
    return nullptr;
  }
  const auto found = std::lower_bound(
      origins.begin(), origins.end(), part.span.begin,
      [](const Part& origin, std::uint32_t begin) { return origin.span.begin < begin; });
  return found != origins.end() && same_place(found->span, part.span) ? &*found : nullptr;
}

bool same_frame(const Expression& a, const Expression& b) {
  return a.kind == b.kind && a.labels == b.labels && a.name == b.name && a.place == b.place &&
         a.description == b.description && a.closing_comments == b.closing_comments;
}

bool same_frame(const Statement& a, const Statement& b) {
  return a.kind == b.kind && a.keyword == b.keyword && a.name == b.name && a.place == b.place &&
         a.description == b.description && a.text == b.text;
}

std::string to_text(double number) {
  std::array<char, 512> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  return {text.data(), end.ptr};
}

}  // namespace

std::string print(const Mission& mission) { return Printer("").print(mission, {}); }

std::string print(const Mission& mission, std::string_view source) {
  std::string kept = Printer(source).print(mission, parse(source).mission);
  // A comment may stand where it belongs to what comes later: between `from` and what is made, or
  // behind the `=` of a slot. When only one side of it was edited, it would be told twice or not.
  return parse(kept).mission == mission ? kept : print(mission);
}

std::string Printer::print(const Mission& mission, const Mission& origin) {
  const Statement* before = nullptr;
  for (const Statement& next : mission.statements) {
    const bool first = &next == mission.statements.data();
    const Statement* from = origin_of(next, origin.statements);
    end_team_before(next, mission);
    const bool follows = from != nullptr && from->comments == next.comments &&
                         (first ? from == origin.statements.data() : from - 1 == before);
    if (follows) {
      copy(first ? 0 : before->span.end, from->span.begin);
    } else {
      out_ += first ? "" : "\n\n";
      comments(next.comments, 0);
    }
    statement(next, from);
    before = from;
  }
  const bool ends = mission.closing_comments == origin.closing_comments &&
                    (origin.statements.empty() ? mission.statements.empty()
                                               : before == &origin.statements.back());
  if (ends && !source_.empty()) {
    copy(before == nullptr ? 0 : before->span.end, static_cast<std::uint32_t>(source_.size()));
  } else {
    out_ += mission.statements.empty() ? "" : "\n";
    comments(mission.closing_comments, 0);
  }
  return std::move(out_);
}

void Printer::end_team_before(const Statement& next, const Mission& mission) {
  const auto is_team = [](const Statement& one) {
    return one.kind == Statement::Kind::Configuration;
  };
  const bool second_team =
      &next != mission.statements.data() && is_team(next) && is_team(*(&next - 1));
  if (second_team && !out_.ends_with(';')) {
    out_ += ';';
  }
}

void Printer::statement(const Statement& statement, const Statement* origin) {
  if (origin != nullptr && same_frame(statement, *origin)) {
    const Span& body = origin->body.span;
    if (statement.body == origin->body) {
      copy(origin->span.begin, origin->span.end);
    } else {
      copy(origin->span.begin, body.begin);
      expression(statement.body, &origin->body, 0);
      copy(body.end, origin->span.end);
    }
    return;
  }
  heading(statement);
  expression(statement.body, origin == nullptr ? nullptr : &origin->body, 0);
  out_ += statement.kind == Statement::Kind::Configuration ? "" : ";";
}

void Printer::heading(const Statement& statement) {
  switch (statement.kind) {
    case Statement::Kind::BindArchitecture:
      out_ += statement.keyword + ' ' + statement.name;
      break;
    case Statement::Kind::Instantiation:
      out_ += statement.keyword;
      headings(statement.place, statement.description, " ");
      out_ += ' ' + statement.name + " from ";
      break;
    case Statement::Kind::Definition:
      out_ += statement.text;
      break;
    case Statement::Kind::Configuration:
      break;
  }
}

void Printer::expression(const Expression& expression, const Expression* origin, int depth) {
  if (origin != nullptr && expression == *origin) {
    copy(origin->span.begin, origin->span.end);
    return;
  }
  const bool framed = origin != nullptr && same_frame(expression, *origin) &&
                      !expression.items.empty() && !origin->items.empty();
  const auto from = [&](const Item& item) {
    return origin == nullptr ? nullptr : origin_of(item, origin->items);
  };
  const bool opened = framed && from(expression.items.front()) == &origin->items.front() &&
                      expression.items.front().comments == origin->items.front().comments;
  if (opened) {
    copy(origin->span.begin, origin->items.front().span.begin);
  } else {
    open(expression);
  }
  items(expression, origin, depth + 1);
  if (framed && from(expression.items.back()) == &origin->items.back()) {
    copy(origin->items.back().span.end, origin->span.end);
  } else {
    close(expression, depth);
  }
}

void Printer::open(const Expression& expression) {
  for (const std::string& label : expression.labels) {
    out_ += label + ':';
  }
  switch (expression.kind) {
    case Expression::Kind::Nothing:
      break;
    case Expression::Kind::Reference:
      out_ += expression.name;
      break;
    case Expression::Kind::Value:
      out_ += '{' + expression.name + '}';
      break;
    case Expression::Kind::Instance:
      out_ += expression.name + '(';
      break;
    case Expression::Kind::Group:
      out_ += '[';
      break;
    case Expression::Kind::Rule:
      out_ += "if ";
      break;
  }
}

void Printer::close(const Expression& expression, int depth) {
  if (!expression.closing_comments.empty()) {
    new_line(depth + 1);
    comments(expression.closing_comments, depth + 1);
    out_.resize(out_.size() - 2);
  }
  if (expression.kind == Expression::Kind::Instance) {
    out_ += ')';
  } else if (expression.kind == Expression::Kind::Group) {
    out_ += ']';
  } else if (expression.kind == Expression::Kind::Rule) {
    out_ += " goto " + expression.name;
  }
  headings(expression.place, expression.description, "");
}

void Printer::items(const Expression& expression, const Expression* origin, int depth) {
  const Item* before = nullptr;
  const bool is_rule = expression.kind == Expression::Kind::Rule;
  for (const Item& next : expression.items) {
    const bool first = &next == expression.items.data();
    const Item* from = origin == nullptr ? nullptr : origin_of(next, origin->items);
    const bool same = from != nullptr && from->comments == next.comments;
    if (!first && same && before != nullptr && from - 1 == before) {
      copy(before->span.end, from->span.begin);
    } else if (!first ||
               !(same && same_frame(expression, *origin) && from == origin->items.data())) {
      out_ += first ? "" : ",";
      if (!is_rule || !next.comments.empty()) {
        new_line(depth);
      }
      comments(next.comments, depth);
    }
    item(next, from, is_rule ? depth - 1 : depth);
    before = from;
  }
}

void Printer::item(const Item& item, const Item* origin, int depth) {
  const Expression* value = origin == nullptr ? nullptr : &origin->value;
  if (item.slot && origin != nullptr && item.slot == origin->slot) {
    copy(origin->span.begin, value->span.begin);
  } else if (item.slot) {
    slot(*item.slot);
  }
  expression(item.value, value, depth);
}

void Printer::slot(const Slot& slot) {
  out_ += (slot.is_parameter ? "%" : "") + slot.name;
  if (slot.index) {
    out_ += '[' + *slot.index + ']';
  }
  headings(slot.place, slot.description, "");
  out_ += " = ";
}

void Printer::comments(const Comments& comments, int depth) {
  for (const std::string& comment : comments) {
    out_ += comment;
    new_line(depth);
  }
}

void Printer::new_line(int depth) {
  out_ += '\n';
  out_.append(static_cast<std::size_t>(2 * depth), ' ');
}

void Printer::headings(const std::optional<Place>& place,
                       const std::optional<std::string>& description, std::string_view between) {
  if (place) {
    out_ += '<' + to_text(place->x) + ',' + to_text(place->y) + '>';
  }
  if (description) {
    out_ += std::string(between) + '|' + *description + '|';
  }
}

void Printer::copy(std::uint32_t begin, std::uint32_t end) {
  out_ += source_.substr(begin, end - begin);
}

}  // namespace tacit::cdl
