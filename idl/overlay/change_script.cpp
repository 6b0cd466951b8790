#include "idl/overlay/change_script.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "idl/overlay/reader.h"
#include "idl/overlay/tokens.h"

namespace tacit {
namespace {

/// The words of one line, taken one after another.
class Line {
 public:
  explicit Line(const std::vector<MapToken>& tokens) : tokens_(tokens) {}

  [[nodiscard]] bool done() const { return next_ == tokens_.size(); }

  std::string word(std::string_view wanted) { return capitals(take(wanted).text); }

  void expect(std::string_view keyword) {
    const MapToken& token = take(keyword);
    if (capitals(token.text) != keyword) throw refusal(token, keyword);
  }

  double number(std::string_view wanted) {
    const MapToken& token = take(wanted);
    if (token.kind != MapToken::Kind::Number) throw refusal(token, wanted);
    return token.number;
  }

  double positive(std::string_view wanted) {
    const double value = number(wanted);
    if (value <= 0.0) throw refusal(tokens_[next_ - 1], wanted);
    return value;
  }

  std::int64_t whole(std::string_view wanted, double least) {
    constexpr double kMost = 9e15;
    const double value = number(wanted);
    if (value != std::floor(value) || value < least || value > kMost) {
      throw refusal(tokens_[next_ - 1], wanted);
    }
    return static_cast<std::int64_t>(value);
  }

  void expect_end() const {
    if (!done()) throw refusal(tokens_[next_], "the end of the line");
  }

  [[nodiscard]] MapRefusal refuse_last(std::string_view wanted) const {
    return refusal(tokens_[next_ - 1], wanted);
  }

 private:
  const MapToken& take(std::string_view wanted) {
    if (done()) {
      const MapToken& last = tokens_.back();
      const auto width = static_cast<std::uint32_t>(last.end - last.begin);
      throw MapRefusal{{Severity::Error,
                        {last.at.line, last.at.column + width},
                        "found the end of the line, wanted " + std::string(wanted)}};
    }
    return tokens_[next_++];
  }

  const std::vector<MapToken>& tokens_;
  std::size_t next_ = 0;
};

ChangeStep step(Line line) {
  ChangeStep step;
  step.start = line.whole("a step, a whole number of at least 0", 0.0);
  if (!line.done()) {
    step.period = line.whole("a period, a whole number of at least 1", 1.0);
  }
  line.expect_end();
  return step;
}

Change obstacle(ObstacleChange::Kind kind, Line line) {
  line.expect("OBSTACLE");
  ObstacleChange change{kind, {}};
  change.obstacle.centre.x_m = line.number("a number (x)");
  change.obstacle.centre.y_m = line.number("a number (y)");
  change.obstacle.radius_m = line.positive("a radius above 0");
  line.expect_end();
  return change;
}

RegionAdd region_add(RegionAdd region, Line& line) {
  region.cover_percent = line.number("a cover of 0 to 100 %");
  if (region.cover_percent < 0.0 || region.cover_percent > 100.0) {
    throw line.refuse_last("a cover of 0 to 100 %");
  }
  region.least_radius_m = line.positive("the smallest radius, above 0");
  region.most_radius_m = line.positive("the largest radius, above 0");
  if (region.most_radius_m < region.least_radius_m) {
    throw line.refuse_last("the largest radius, not below the smallest");
  }
  if (!line.done()) region.seed = line.whole("a seed, a whole number", -9e15);
  if (!line.done()) region.increment = line.whole("an increment, a whole number", -9e15);
  return region;
}

Change region(Line line) {
  RegionAdd region;
  region.from.x_m = line.number("a number (x0)");
  region.from.y_m = line.number("a number (y0)");
  region.to.x_m = line.number("a number (x1)");
  region.to.y_m = line.number("a number (y1)");
  const std::string verb = line.word("ADD or REMOVE");
  if (verb != "ADD" && verb != "REMOVE") throw line.refuse_last("ADD or REMOVE");
  line.expect("OBSTACLE");
  if (verb == "ADD") region = region_add(region, line);
  line.expect_end();
  return verb == "ADD" ? Change(region) : Change(RegionRemove{region.from, region.to});
}

void take_line(const std::vector<MapToken>& tokens, ChangeScript& script) {
  Line line(tokens);
  const std::string keyword = line.word("a statement");
  if (keyword == "STEP_COUNT") {
    script.push_back(step(line));
    return;
  }
  const bool known = keyword == "ADD" || keyword == "REMOVE" || keyword == "REGION";
  if (!known) throw refusal(tokens.front(), "STEP_COUNT, ADD, REMOVE or REGION");
  if (script.empty()) throw refusal(tokens.front(), "STEP_COUNT before the first change");
  const auto kind = keyword == "ADD" ? ObstacleChange::Kind::Add : ObstacleChange::Kind::Remove;
  script.back().changes.push_back(keyword == "REGION" ? region(line) : obstacle(kind, line));
}

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text += ' ' + std::string(digits.data(), end);
  }
  return text;
}

struct Printer {
  std::string operator()(const ObstacleChange& change) const {
    const MapObstacle& one = change.obstacle;
    return (change.kind == ObstacleChange::Kind::Add ? "add obstacle" : "remove obstacle") +
           numbers({one.centre.x_m, one.centre.y_m, one.radius_m});
  }
  std::string operator()(const RegionAdd& region) const {
    std::string text = place(region.from, region.to) + " add obstacle" +
                       numbers({region.cover_percent, region.least_radius_m, region.most_radius_m});
    if (!region.seed) return text;
    text += ' ' + std::to_string(*region.seed);
    return region.increment ? text + ',' + std::to_string(*region.increment) : text;
  }
  std::string operator()(const RegionRemove& region) const {
    return place(region.from, region.to) + " remove obstacle";
  }
  static std::string place(const MapPoint& from, const MapPoint& to) {
    return "region" + numbers({from.x_m, from.y_m, to.x_m, to.y_m});
  }
};

}  // namespace

ChangeReading read_changes(std::string_view text) {
  ChangeReading reading;
  std::vector<MapToken> tokens;
  std::size_t at = 0;
  for (std::uint32_t line = 1; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    tokens.clear();
    (void)add_tokens(text, at, end, line, tokens);
    at = end + 1;
    try {
      if (!tokens.empty()) take_line(tokens, reading.script);
    } catch (const MapRefusal& refused) {
      if (reading.findings.size() < kMostFindings) reading.findings.push_back(refused.finding);
    }
  }
  return reading;
}

std::string to_text(const ChangeScript& script) {
  std::string text;
  for (const ChangeStep& step : script) {
    text += "STEP_COUNT " + std::to_string(step.start);
    text += step.period ? ' ' + std::to_string(*step.period) + '\n' : "\n";
    for (const Change& change : step.changes) {
      text += std::visit(Printer{}, change) + '\n';
    }
  }
  return text;
}

}  // namespace tacit
