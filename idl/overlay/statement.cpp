#include "idl/overlay/statement.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace tacit {
namespace {

constexpr std::size_t kMany = 1'000'000;

// In the order of the enumerators; the last of them has two spellings.
constexpr std::array<ShapeForm, 17> kShapes{{
    {"AA", ShapeKind::AssemblyArea, 1, kMany},
    {"ATK", ShapeKind::Attack, 1, kMany},
    {"AXIS", ShapeKind::Axis, 1, kMany},
    {"BOUNDARY", ShapeKind::Boundary, 2, kMany},
    {"BP", ShapeKind::BattlePosition, 1, kMany},
    {"GAP", ShapeKind::Gap, 2, 2},
    {"LDLC", ShapeKind::DepartureLine, 1, kMany},
    {"OBJ", ShapeKind::Objective, 1, kMany},
    {"PP", ShapeKind::PassagePoint, 1, 1},
    {"SP", ShapeKind::StartPoint, 1, 1},
    {"PL", ShapeKind::PhaseLine, 1, kMany},
    {"ATTRACTOR", ShapeKind::Attractor, 1, kMany},
    {"BASKET", ShapeKind::Basket, 1, kMany},
    {"WALL", ShapeKind::Wall, 2, kMany},
    {"ROOM", ShapeKind::Room, 3, kMany},
    {"DOOR", ShapeKind::Door, 2, 2},
    {"ZONE", ShapeKind::Zone, 1, kMany},
}};

constexpr std::array<HeaderForm, 11> kHeaders{{
    {"SCENARIO", HeaderKind::Scenario, true, 1, 1, 0, 0},
    {"SITE", HeaderKind::Site, true, 1, 1, 0, 0},
    {"ORIGIN", HeaderKind::Origin, false, 0, kMany, 0, kMany},
    {"GLOBAL_REF_POINT", HeaderKind::GlobalRefPoint, false, 0, 0, 2, 3},
    {"HEADING", HeaderKind::Heading, false, 0, 0, 1, 1},
    {"MISSION-AREA", HeaderKind::MissionArea, false, 0, 0, 2, 2},
    {"LOAD-MAP", HeaderKind::LoadMap, true, 1, 1, 0, 0},
    {"HEIGHTMAP", HeaderKind::HeightMap, true, 1, 1, 0, 4},
    {"SET", HeaderKind::Set, false, 1, kMany, 0, kMany},
    {"SCALE", HeaderKind::Scale, false, 0, 0, 1, 1},
    {"WAYPOINT-FILE", HeaderKind::WaypointFile, true, 1, 2, 0, 0},
}};

template <class Forms>
auto form_called(const Forms& forms, std::string_view keyword) {
  const auto* form = std::find_if(forms.begin(), forms.end(),
                                  [&](const auto& one) { return one.keyword == keyword; });
  return form == forms.end() ? nullptr : form;
}

/// The words of a statement, taken one after another.
class Words {
 public:
  explicit Words(std::span<const MapToken> tokens) : tokens_(tokens) {}

  [[nodiscard]] bool done() const { return next_ == tokens_.size(); }
  [[nodiscard]] bool at_number() const {
    return !done() && tokens_[next_].kind == MapToken::Kind::Number;
  }
  [[nodiscard]] bool at_word(std::string_view keyword) const {
    return !done() && capitals(tokens_[next_].text) == keyword;
  }

  const MapToken& take(std::string_view wanted) {
    if (done()) {
      throw refuse_end(wanted);
    }
    return tokens_[next_++];
  }

  double number(std::string_view wanted) {
    const MapToken& token = take(wanted);
    if (token.kind != MapToken::Kind::Number) {
      throw refusal(token, wanted);
    }
    return token.number;
  }

  /// All numbers up to the next word.
  std::vector<double> numbers() {
    std::vector<double> all;
    all.reserve(tokens_.size() - next_);
    while (at_number()) {
      all.push_back(tokens_[next_++].number);
    }
    return all;
  }

  std::vector<MapPoint> points(std::size_t fewest, std::string_view wanted) {
    const std::vector<double> all = numbers();
    if (all.size() % 2 != 0 || all.size() < 2 * fewest) {
      throw done() ? refuse_end(wanted) : refusal(tokens_[next_], wanted);
    }
    return paired(all);
  }

  static std::vector<MapPoint> paired(const std::vector<double>& numbers) {
    std::vector<MapPoint> all;
    all.reserve(numbers.size() / 2);
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      all.push_back({numbers[i], numbers[i + 1]});
    }
    return all;
  }

  void expect_word(std::string_view keyword) {
    const MapToken& token = take(keyword);
    if (capitals(token.text) != keyword) {
      throw refusal(token, keyword);
    }
  }

  void expect_end(std::string_view wanted) const {
    if (!done()) {
      throw refusal(tokens_[next_], wanted);
    }
  }

  [[nodiscard]] MapRefusal refuse_end(std::string_view wanted) const {
    const MapToken& last = tokens_.back();
    const MapSpot at{last.at.line,
                     last.at.column + static_cast<std::uint32_t>(last.end - last.begin)};
    return {
        {Severity::Error, at,
         "found the end of " + capitals(tokens_.front().text) + ", wanted " + std::string(wanted)}};
  }

  /// A name may be missing.
  std::string name() {
    return done() || at_number() ? std::string() : std::string(tokens_[next_++].text);
  }

 private:
  std::span<const MapToken> tokens_;
  std::size_t next_ = 1;
};

std::string points_wanted(const ShapeForm& form) {
  const std::string fewest = std::to_string(form.fewest_points);
  const std::string points = fewest == "1" ? " point" : " points";
  return (form.most_points == form.fewest_points ? fewest : "at least " + fewest) + points +
         " (x y), then at most one number";
}

MapShape shape(const ShapeForm& form, Words words) {
  MapShape shape{form.kind, words.name(), {}, {}};
  const std::vector<double> numbers = words.numbers();
  words.expect_end("a number or the end of the line");
  shape.points = Words::paired(numbers);
  if (numbers.size() % 2 != 0) {
    shape.size_m = numbers.back();
  }
  if (shape.points.size() < form.fewest_points || shape.points.size() > form.most_points) {
    throw words.refuse_end(points_wanted(form));
  }
  return shape;
}

MapHeader header(const HeaderForm& form, Words words) {
  MapHeader header{form.kind, {}, {}};
  while (!words.done() && !words.at_number() && header.words.size() < form.most_words) {
    header.words.emplace_back(words.take("a word").text);
  }
  // The text of a map that consists of digits is still a text.
  if (header.words.size() < form.fewest_words) {
    header.words.emplace_back(words.take("a text in quotes").text);
  }
  while (words.at_number() && header.numbers.size() < form.most_numbers) {
    header.numbers.push_back(words.number("a number"));
  }
  if (header.numbers.size() < form.fewest_numbers) {
    (void)words.number("a number");
  }
  words.expect_end("the end of the line");
  return header;
}

MapObstacle obstacle(Words words) {
  MapObstacle obstacle;
  obstacle.name = words.name();
  obstacle.centre.x_m = words.number("a number (x)");
  obstacle.centre.y_m = words.number("a number (y)");
  obstacle.radius_m = words.number("a number (radius)");
  if (!words.done()) {
    obstacle.height_m = words.number("a number (height) or the end of the line");
  }
  words.expect_end("the end of the line");
  return obstacle;
}

Mobility mobility(const MapToken& token) {
  const std::string word = capitals(token.text);
  if (word == "FIXED") return Mobility::Fixed;
  if (word == "MOVABLE") return Mobility::Movable;
  if (word == "CONTAINER") return Mobility::Container;
  throw refusal(token, "FIXED, MOVABLE or CONTAINER");
}

MapObject object(Words words) {
  MapObject object;
  object.centre.x_m = words.number("a number (x)");
  object.centre.y_m = words.number("a number (y)");
  object.radius_m = words.number("a number (radius)");
  object.mobility = mobility(words.take("FIXED, MOVABLE or CONTAINER"));
  object.colour = words.take("a colour").text;
  words.expect_end("the end of the line");
  return object;
}

MapHallway hallway(Words words) {
  MapHallway hallway;
  if (!words.at_word("CENTERLINE")) {
    hallway.name = words.name();
  }
  words.expect_word("CENTERLINE");
  hallway.centre_line = words.points(2, "at least 2 points (x y) of the centre line, then WIDTH");
  words.expect_word("WIDTH");
  hallway.width_m = words.number("a number (width)");
  words.expect_word("EXTENTS");
  hallway.outline = words.points(3, "at least 3 points (x y) of the outline");
  words.expect_end("a number or the end of the line");
  return hallway;
}

MapContent unknown(std::span<const MapToken> tokens) {
  std::string text;
  for (const MapToken& token : tokens) {
    const char* quote = token.kind == MapToken::Kind::Quoted ? "\"" : "";
    text += (text.empty() ? "" : " ") + (quote + std::string(token.text)) + quote;
  }
  return MapUnknown{text};
}

/// Whether it is "CONTROL MEASURES:", with or without the colon.
bool is_measures(std::span<const MapToken> tokens) {
  std::string text;
  for (const MapToken& token : tokens.first(std::min<std::size_t>(tokens.size(), 4))) {
    text += capitals(token.text);
  }
  return text == "CONTROLMEASURES" || text == "CONTROLMEASURES:";
}

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = corner + (a[i] == b[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, corner + 1});
    }
  }
  return row.back();
}

}  // namespace

const ShapeForm& form_of(ShapeKind kind) { return kShapes[static_cast<std::size_t>(kind)]; }
const HeaderForm& form_of(HeaderKind kind) { return kHeaders[static_cast<std::size_t>(kind)]; }

MapContent content_of(std::span<const MapToken> tokens) {
  const std::string keyword = capitals(tokens.front().text);
  if (tokens.front().kind != MapToken::Kind::Word) return unknown(tokens);
  if (const ShapeForm* form = form_called(kShapes, keyword)) return shape(*form, Words(tokens));
  if (const HeaderForm* form = form_called(kHeaders, keyword)) return header(*form, Words(tokens));
  if (keyword == "OBSTACLE") return obstacle(Words(tokens));
  if (keyword == "OBJECT") return object(Words(tokens));
  if (keyword == "HALLWAY") return hallway(Words(tokens));
  return is_measures(tokens) ? MapContent(MapMeasures{}) : unknown(tokens);
}

std::string_view nearest_keyword(std::string_view typed) {
  constexpr std::size_t kNear = 2;
  std::string_view best;
  std::size_t least = kNear + 1;
  const std::string word = capitals(typed.substr(0, 40));
  const auto consider = [&](std::string_view known) {
    const std::size_t far = distance(word, known);
    if (far < least && far < known.size() / 2) {
      least = far;
      best = known;
    }
  };
  for (const ShapeForm& form : kShapes) consider(form.keyword);
  for (const HeaderForm& form : kHeaders) consider(form.keyword);
  for (const std::string_view other : {"OBSTACLE", "OBJECT", "HALLWAY", "CONTROL"}) consider(other);
  return best;
}

}  // namespace tacit
