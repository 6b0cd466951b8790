#include "wizard_service/cases/case_text.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <vector>

#include "idl/types/config_error.h"
#include "idl/types/lowered.h"
#include "wizard_service/cbr/features.h"
#include "wizard_service/cbr/plan_cdl.h"

namespace tacit::cbr {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t\r\n\f\v";
constexpr std::string_view kOn = " on ";
constexpr std::string_view kOf = " of ";
constexpr std::uint64_t kMilli = 1000;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// What a line of the block says, without the star in front.
std::string_view said(std::string_view line) {
  line = trimmed(line);
  const std::size_t first = line.find_first_not_of('*');
  return first == std::string_view::npos ? std::string_view() : trimmed(line.substr(first));
}

std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc() || stop != end) return std::nullopt;
  return number;
}

/// "9.5" as 9500.
std::optional<std::uint64_t> thousandths(std::string_view text) {
  const std::size_t dot = text.find('.');
  std::string digits(text.substr(0, dot));
  std::string_view rest = dot == std::string_view::npos ? "0" : text.substr(dot + 1);
  if (digits.empty() || digits.size() > 12 || rest.empty() || rest.size() > 3) return std::nullopt;
  digits += rest;
  digits.append(3 - rest.size(), '0');
  return whole(digits);
}

std::string in_thousandths(std::uint64_t milli) {
  const std::string rest = std::to_string(milli % kMilli);
  return std::to_string(milli / kMilli) + '.' + std::string(3 - rest.size(), '0') + rest;
}

std::uint32_t count(std::string_view value, std::string_view key) {
  constexpr std::uint64_t kMost = 1'000'000'000;
  const std::optional<std::uint64_t> number = whole(value);
  if (!number || *number > kMost) {
    throw ConfigError(std::string(key) + ": found \"" + std::string(value) +
                      "\", wanted a whole number, 0 to 1000000000");
  }
  return static_cast<std::uint32_t>(*number);
}

void read_outcomes(TrackRecord& record, std::string_view value) {
  const std::size_t of = value.find(kOf);
  const bool parted = of != std::string_view::npos;
  const auto good = thousandths(trimmed(value.substr(0, of)));
  if (!parted || !good) {
    throw ConfigError("Outcomes: found \"" + std::string(value) +
                      "\", wanted how many were good of how many, as 9.500 of 10");
  }
  record.outcomes = count(trimmed(value.substr(of + kOf.size())), "Outcomes");
  record.good_milli = *good;
  if (record.good_milli > record.outcomes * kMilli) {
    throw ConfigError("Outcomes: found " + std::string(value) + ", wanted at most as many good");
  }
}

Failure failure_from(std::string_view value) {
  const std::size_t on = value.rfind(kOn);
  if (on == std::string_view::npos) return {std::string(value), {}};
  const std::string_view map = trimmed(value.substr(on + kOn.size()));
  return {std::string(trimmed(value.substr(0, on))), map == "-" ? "" : std::string(map)};
}

struct Line {
  std::string_view text;
  std::size_t number = 0;
};

/// The lines of the comment block at the front. Throws ConfigError when there is none.
std::vector<Line> block_of(std::string_view text, std::string_view name) {
  std::size_t begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  begin = std::min(text.find_first_not_of(kBlanks, begin), text.size());
  const std::size_t end = text.find("*/", std::min(begin + 2, text.size()));
  if (!text.substr(begin).starts_with("/*") || end == std::string_view::npos) {
    throw ConfigError(std::string(name) +
                      ":1: found no comment block at the front, wanted one with the case's "
                      "features: /* Task: BiohazardTask */");
  }
  std::size_t number =
      1 + static_cast<std::size_t>(
              std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
  std::vector<Line> lines;
  for (std::size_t at = begin + 2; at <= end; ++number) {
    const std::size_t stop = std::min(text.find('\n', at), end);
    lines.push_back({said(text.substr(at, stop - at)), number});
    at = stop + 1;
  }
  return lines;
}

/// Reads the lines of a block into a case.
class BlockReader {
 public:
  /// Throws ConfigError without a place.
  void read(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) {
      throw ConfigError("found \"" + std::string(line) + "\", wanted a key and a value: Task: …");
    }
    const std::string_view key = trimmed(line.substr(0, colon));
    const std::string_view value = trimmed(line.substr(colon + 1));
    const std::string small = lowered(key);
    if (small != "failure" && !seen_.insert(small).second) {
      throw ConfigError("found " + std::string(key) + " a second time, wanted it once");
    }
    if (read_record(small, value)) return;
    if (small == "task") case_.features = usual_features(task_called(value));
    check(key, value);
    features_.emplace_back(key, value);
  }

  [[nodiscard]] bool has_task() const { return seen_.contains("task"); }
  /// The case without its plan.
  [[nodiscard]] Case take(std::size_t robots) {
    case_.features.robots = static_cast<int>(robots);
    for (const auto& [key, value] : features_) set_feature(case_.features, key, value);
    return std::move(case_);
  }

 private:
  /// Returns false when it is a feature.
  bool read_record(const std::string& key, std::string_view value) {
    if (key == "case") {
      case_.title = value;
    } else if (key == "uses") {
      case_.record.uses = count(value, "Uses");
    } else if (key == "outcomes") {
      read_outcomes(case_.record, value);
    } else if (key == "failure") {
      case_.record.failures.push_back(failure_from(value));
    } else {
      return false;
    }
    return true;
  }

  static void check(std::string_view key, std::string_view value) {
    CaseFeatures tried;
    set_feature(tried, key, value);
  }

  Case case_;
  std::set<std::string> seen_;
  std::vector<std::pair<std::string_view, std::string_view>> features_;
};

void refuse_too_many(const Case& one, std::string_view name) {
  const std::size_t robots = one.plan.robots.size();
  if (robots > static_cast<std::size_t>(kMostPlannedRobots)) {
    throw ConfigError(std::string(name) + ": found " + std::to_string(robots) +
                      " robots, wanted at most " + std::to_string(kMostPlannedRobots));
  }
  if (one.record.failures.size() > kFailuresKept) {
    throw ConfigError(std::string(name) + ": found " + std::to_string(one.record.failures.size()) +
                      " failures, wanted at most " + std::to_string(kFailuresKept));
  }
}

void append(std::string& text, std::string_view key, std::string_view value) {
  text += (text.empty() ? "" : "\n * ") + std::string(key) + ": " + std::string(value);
}

std::string to_text(const Failure& failure) {
  const std::string what = one_line(failure.what);
  std::string map = ' ' + one_line(failure.map);
  for (std::size_t at = 0; (at = map.find(kOn)) != std::string::npos;) map.replace(at, 4, "_on_");
  map = one_line(map);
  if (map.empty() && what.find(kOn) == std::string::npos) return what;
  return what + std::string(kOn) + (map.empty() ? "-" : map);
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(),
      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
  for (std::size_t at = 0; (at = line.find("*/", at)) != std::string::npos;)
    line.insert(++at, 1, ' ');
  return std::string(trimmed(line));
}

Case case_from(std::string_view text, std::string_view name) {
  BlockReader reader;
  const std::vector<Line> block = block_of(text, name);
  for (const Line& line : block) {
    if (line.text.empty()) continue;
    try {
      reader.read(line.text);
    } catch (const ConfigError& error) {
      throw ConfigError(std::string(name) + ':' + std::to_string(line.number) + ": " +
                        error.what());
    }
  }
  if (!reader.has_task()) {
    throw ConfigError(std::string(name) + ':' + std::to_string(block.front().number) +
                      ": found no Task in the comment block, wanted one: Task: BiohazardTask");
  }
  Plan plan = plan_of(text, name);
  Case one = reader.take(plan.robots.size());
  one.plan = std::move(plan);
  one.origin = name;
  refuse_too_many(one, name);
  return one;
}

std::string to_text(const Case& one) {
  std::string head;
  append(head, "Case", one_line(one.title));
  for (const FeatureRow& row : feature_table()) {
    append(head, row.name, row.values[code(one.features, row.feature)]);
  }
  const TrackRecord& record = one.record;
  if (record.uses > 0) append(head, "Uses", std::to_string(record.uses));
  if (record.outcomes > 0) {
    append(head, "Outcomes",
           in_thousandths(record.good_milli) + " of " + std::to_string(record.outcomes));
  }
  for (const Failure& failure : record.failures) append(head, "Failure", to_text(failure));
  return mission_text(one.plan, head + '\n');
}

}  // namespace tacit::cbr
