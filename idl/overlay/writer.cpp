#include "idl/overlay/writer.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "idl/overlay/reader.h"
#include "idl/overlay/statement.h"
#include "idl/overlay/tokens.h"

namespace tacit {
namespace {

std::string number(double value) {
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string quoted(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '"' || c == '\n'; }, ' ');
  return '"' + text + '"';
}

/// Whether `text` reads back as one word without quotes.
bool is_plain(const std::string& text) {
  return !text.empty() && text.find_first_of(" ,\t\r\n\f\v\"") == std::string::npos &&
         text.find("--") == std::string::npos && !map_number(text);
}

std::string listed(const std::vector<MapPoint>& points) {
  std::string text;
  for (const MapPoint& point : points) {
    text += ' ' + number(point.x_m) + ' ' + number(point.y_m);
  }
  return text;
}

std::string optional_number(const std::optional<double>& value) {
  return value ? ' ' + number(*value) : "";
}

std::string_view word(Mobility mobility) {
  switch (mobility) {
    case Mobility::Fixed:
      return "FIXED";
    case Mobility::Movable:
      return "MOVABLE";
    case Mobility::Container:
      return "CONTAINER";
  }
  return "";
}

struct Printer {
  std::string operator()(const MapUnknown& unknown) const { return unknown.text; }
  std::string operator()(const MapMeasures&) const { return "CONTROL MEASURES:"; }
  std::string operator()(const MapHeader& header) const {
    const HeaderForm& form = form_of(header.kind);
    std::string text(form.keyword);
    for (const std::string& one : header.words) {
      text += ' ' + (form.quoted || !is_plain(one) ? quoted(one) : one);
    }
    for (const double value : header.numbers) {
      text += ' ' + number(value);
    }
    return text;
  }
  std::string operator()(const MapShape& shape) const {
    return std::string(form_of(shape.kind).keyword) + ' ' + quoted(shape.name) +
           listed(shape.points) + optional_number(shape.size_m);
  }
  std::string operator()(const MapObstacle& obstacle) const {
    const std::string name = obstacle.name.empty() ? "" : ' ' + quoted(obstacle.name);
    return "OBSTACLE" + name + listed({obstacle.centre}) + ' ' + number(obstacle.radius_m) +
           optional_number(obstacle.height_m);
  }
  std::string operator()(const MapObject& object) const {
    return "OBJECT" + listed({object.centre}) + ' ' + number(object.radius_m) + ' ' +
           std::string(word(object.mobility)) + ' ' + quoted(object.colour);
  }
  std::string operator()(const MapHallway& hallway) const {
    return "HALLWAY " + quoted(hallway.name) + " CENTERLINE" + listed(hallway.centre_line) +
           " WIDTH " + number(hallway.width_m) + " EXTENTS" + listed(hallway.outline);
  }
};

/// Whether the statement's own text still says what it means.
bool is_unchanged(const MapStatement& statement) {
  if (statement.spelled.empty()) return false;
  if (const auto* unknown = std::get_if<MapUnknown>(&statement.content)) {
    return unknown->text == statement.spelled;
  }
  const OverlayReading reading = read_overlay(statement.spelled);
  return reading.map.statements.size() == 1 &&
         reading.map.statements.front().content == statement.content;
}

std::string spelled_or_new(const MapStatement& statement) {
  return is_unchanged(statement) ? statement.spelled : to_text(statement.content);
}

/// Whether a comment stands between the lines of a statement.
bool holds_comment(std::string_view spelled) {
  bool quoted = false;
  for (std::size_t i = 0; i + 1 < spelled.size(); ++i) {
    const char c = spelled[i];
    quoted = c != '\n' && (quoted != (c == '"'));
    if (!quoted && c == '-' && spelled[i + 1] == '-') return true;
  }
  return false;
}

template <class Spell>
std::string printed(const OverlayMap& map, Spell spell) {
  std::string text;
  for (const MapStatement& statement : map.statements) {
    const bool on_a_line_of_its_own =
        text.empty() || text.back() == '\n' || statement.before.find('\n') != std::string::npos;
    text += (on_a_line_of_its_own ? "" : "\n") + statement.before;
    text += spell(statement);
  }
  text += map.ending;
  const bool new_at_the_end = !map.statements.empty() && map.statements.back().spelled.empty();
  return new_at_the_end && text.back() != '\n' ? text + '\n' : text;
}

}  // namespace

std::string to_text(const MapContent& content) { return std::visit(Printer{}, content); }

std::string to_text(const OverlayMap& map) { return printed(map, spelled_or_new); }

std::string to_canonical_text(const OverlayMap& map) {
  return printed(map, [](const MapStatement& statement) {
    return holds_comment(statement.spelled) ? spelled_or_new(statement)
                                            : to_text(statement.content);
  });
}

}  // namespace tacit
