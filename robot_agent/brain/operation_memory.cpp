#include "robot_agent/brain/operation_memory.h"

#include <charconv>
#include <cmath>

#include "idl/types/shortest.h"

namespace tacit {
namespace {

constexpr std::string_view kHead = "tacit-operation-memory 1";

std::string place_line(std::string_view key, const std::optional<OdometryVec>& place_m) {
  std::string line(key);
  if (place_m) line += " " + json_number(place_m->x()) + " " + json_number(place_m->y());
  return line + "\n";
}

/// Takes the text apart at blanks and line ends.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool line(std::string_view key) {
    if (!rest_.starts_with(key)) return false;
    rest_.remove_prefix(key.size());
    return true;
  }
  [[nodiscard]] std::optional<double> number() {
    if (!rest_.starts_with(' ')) return std::nullopt;
    double value = 0.0;
    const char* begin = rest_.data() + 1;
    const auto [end, error] = std::from_chars(begin, rest_.data() + rest_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  [[nodiscard]] bool end_of_line() { return line("\n"); }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

/// Whether a line with `key` and a place, or none, came next.
bool take_place(Words& words, std::string_view key, std::optional<OdometryVec>& place_m) {
  if (!words.line(key)) return false;
  if (const auto x = words.number()) {
    const auto y = words.number();
    if (!y) return false;
    place_m = OdometryVec{*x, *y};
  }
  return words.end_of_line();
}

std::optional<OdometryVec> middle_of(const std::optional<Entrance>& entrance) {
  return entrance ? std::optional(entrance->middle_m) : std::nullopt;
}

std::optional<OdometryVec> inwards_of(const std::optional<Entrance>& entrance) {
  return entrance ? std::optional(entrance->inwards) : std::nullopt;
}

}  // namespace

std::string to_text(const OperationStand& stand) {
  std::string text = std::string(kHead) + "\nbegun " + (stand.begun ? "1" : "0") + "\n" +
                     place_line("home", stand.perception.home_m) +
                     place_line("course", stand.perception.course) +
                     place_line("entrance", middle_of(stand.perception.entrance)) +
                     place_line("inwards", inwards_of(stand.perception.entrance)) +
                     place_line("proceeded", stand.proceeded) + "record";
  for (const double value : stand.record.values()) text += " " + json_number(value);
  return text + "\n";
}

std::optional<OperationStand> parse_operation_stand(std::string_view text) {
  Words words(text);
  OperationStand stand;
  if (!words.line(kHead) || !words.end_of_line() || !words.line("begun")) return std::nullopt;
  const auto begun = words.number();
  if (!begun || (*begun != 0.0 && *begun != 1.0) || !words.end_of_line()) return std::nullopt;
  stand.begun = *begun == 1.0;
  OperationPerception::Memory& seen = stand.perception;
  std::optional<OdometryVec> middle_m;
  std::optional<OdometryVec> inwards;
  if (!take_place(words, "home", seen.home_m) || !take_place(words, "course", seen.course) ||
      !take_place(words, "entrance", middle_m) || !take_place(words, "inwards", inwards) ||
      middle_m.has_value() != inwards.has_value() ||
      !take_place(words, "proceeded", stand.proceeded) || !words.line("record")) {
    return std::nullopt;
  }
  if (middle_m) seen.entrance = {*middle_m, *inwards};
  while (const auto value = words.number()) stand.record.add(*value);
  if (!words.end_of_line() || !words.at_end()) return std::nullopt;
  return stand;
}

}  // namespace tacit
