#include "console/record/event_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

#include "console/record/files.h"
#include "console/record/record_error.h"

namespace tacit {
namespace {

/// Takes one flat JSON object apart, members in the order given. After the first thing that is not
/// as wanted it is not good, and what it gives has no meaning.
class Fields {
 public:
  explicit Fields(std::string_view line) : rest_(line) { pass("{"); }

  template <class Number>
  Fields& number(std::string_view key, Number& value) {
    start(key);
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    good_ = good_ && error == std::errc();
    if constexpr (std::is_floating_point_v<Number>) {
      good_ = good_ && std::isfinite(value);
    }
    skip(static_cast<std::size_t>(end - rest_.data()));
    return *this;
  }
  Fields& place(WorldVec& value, std::string_view x_key, std::string_view y_key) {
    double x = 0.0;
    double y = 0.0;
    number(x_key, x).number(y_key, y);
    value = {x, y};
    return *this;
  }
  std::string_view text(std::string_view key) {
    start(key);
    pass("\"");
    const std::string_view value = rest_.substr(0, rest_.find('"'));
    skip(value.size());
    pass("\"");
    return value;
  }
  /// One of an enumeration's names, `last` being its last value.
  template <class Enum>
  Fields& choice(std::string_view key, Enum& value, Enum last) {
    const std::string_view found = text(key);
    int code = 0;
    while (code <= static_cast<int>(last) && found != name(static_cast<Enum>(code))) {
      ++code;
    }
    good_ = good_ && code <= static_cast<int>(last);
    value = good_ ? static_cast<Enum>(code) : last;
    return *this;
  }
  Fields& flag(std::string_view key, bool& value) {
    start(key);
    value = rest_.starts_with("true");
    pass(value ? "true" : "false");
    return *this;
  }
  Fields& word(std::string_view key, Word& value) {
    start(key);
    pass("\"");
    std::string letters;
    while (good_ && !rest_.empty() && rest_.front() != '"') {
      skip(rest_.front() == '\\' ? 1 : 0);
      letters.append(rest_.substr(0, 1));
      skip(1);
    }
    pass("\"");
    good_ = good_ && Word::fits(letters);
    if (good_) value = Word(letters);
    return *this;
  }
  Fields& digest(std::string_view key, std::uint64_t& value) {
    const std::string_view hex = text(key);
    const char* const end = hex.data() + hex.size();
    const auto read = std::from_chars(hex.data(), end, value, 16);
    good_ = good_ && read.ec == std::errc() && read.ptr == end;
    return *this;
  }
  [[nodiscard]] bool done() const { return good_ && rest_ == "}"; }

 private:
  void start(std::string_view key) {
    pass(first_ ? "\"" : ",\"");
    pass(key);
    pass("\":");
    first_ = false;
  }
  void pass(std::string_view wanted) {
    good_ = good_ && rest_.starts_with(wanted);
    skip(wanted.size());
  }
  void skip(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }

  std::string_view rest_;
  bool good_ = true;
  bool first_ = true;
};

/// Fills an event's members, in the order in which `to_line` writes them.
struct Fill {
  Fields& in;

  void operator()(EnemyCreated& e) const {
    in.number("enemy", e.enemy.value).choice("kind", e.kind, EnemyKind::Hunter);
    in.place(e.position_m, "x_m", "y_m");
  }
  void operator()(EnemyIntercepted& e) const {
    in.number("enemy", e.enemy.value).choice("kind", e.kind, EnemyKind::Hunter);
    in.number("robot", e.robot.value).number("distance_to_target_m", e.distance_to_target_m);
  }
  void operator()(TargetHit& e) const {
    in.number("enemy", e.enemy.value).number("distance_to_target_m", e.distance_to_target_m);
  }
  void operator()(Collision& e) const {
    in.number("robot", e.robot.value).choice("with", e.with, Obstruction::Enemy);
    in.number("other", e.other);
  }
  void operator()(RobotLost& e) const { in.number("robot", e.robot.value); }
  void operator()(RobotBack& e) const { in.number("robot", e.robot.value); }
  void operator()(RobotLate& e) const { in.number("robot", e.robot.value); }
  void operator()(Checkpoint& e) const {
    in.digest("state", e.state_digest).number("enemies", e.enemies);
    in.number("mean_distance_to_target_m", e.mean_distance_to_target_m);
    in.number("mean_speed_mps", e.mean_speed_mps);
  }
  void operator()(RunEnded& e) const { in.digest("state", e.state_digest); }
  void operator()(EnemyRetreated& e) const { in.number("enemy", e.enemy.value); }
  void operator()(MineTaken& e) const {
    in.number("robot", e.robot.value).number("mine", e.mine.value);
  }
  void operator()(MineDropped& e) const {
    in.number("robot", e.robot.value).number("mine", e.mine.value);
    in.place(e.position_m, "x_m", "y_m");
  }
  void operator()(MineStored& e) const {
    in.number("robot", e.robot.value).number("mine", e.mine.value).number("left", e.left);
  }
  void operator()(RobotDisabled& e) const {
    in.number("robot", e.robot.value).choice("by", e.by, Mishap::Enemy);
  }
  void operator()(RobotRevived& e) const {
    in.number("robot", e.robot.value).number("by", e.by.value);
  }
  void operator()(MissionOver& e) const {
    in.choice("verdict", e.verdict, Verdict::OutOfTime).number("score_ticks", e.score_ticks);
  }
  void operator()(ForageBegun& e) const { in.number("mines", e.mines); }
  void operator()(OperationBegun& e) const { in.number("team", e.team).number("extras", e.extras); }
  void operator()(ObjectTaken& e) const { numbered("object", e.robot, e.object.value); }
  void operator()(ObjectDropped& e) const {
    numbered("object", e.robot, e.object.value);
    in.place(e.position_m, "x_m", "y_m");
  }
  void operator()(ObjectStored& e) const {
    numbered("object", e.robot, e.object.value);
    in.number("container", e.container.value);
  }
  void operator()(ObjectTested& e) const {
    numbered("object", e.robot, e.object.value);
    in.choice("finding", e.finding, Finding::Dangerous);
  }
  void operator()(DoorwayMarked& e) const {
    numbered("doorway", e.robot, e.doorway);
    in.flag("marked", e.marked);
  }
  void operator()(SiteEntered& e) const {
    in.number("robot", e.robot.value).choice("site", e.site, Site::Hallway);
    in.number("number", e.number);
  }
  void operator()(PointReached& e) const { numbered("point", e.robot, e.point); }
  void operator()(Signalled& e) const {
    in.number("robot", e.robot.value).word("word", e.word).number("heard", e.heard);
  }
  void operator()(Alerted& e) const { in.number("robot", e.robot.value).word("word", e.word); }
  void operator()(RobotExposed& e) const {
    in.number("robot", e.robot.value).number("to", e.to.value).flag("exposed", e.exposed);
  }
  void operator()(RobotFinished& e) const { in.number("robot", e.robot.value); }
  void operator()(OperatorActed& e) const {
    in.number("robot", e.robot.value).choice("act", e.act, OperatorAct::SkipGoal);
    in.place(e.joystick, "x", "y");
  }

 private:
  void numbered(std::string_view key, RobotId& robot, std::uint32_t& number) const {
    in.number("robot", robot.value).number(key, number);
  }
};

template <class Kind>
Happening filled(Fields& in) {
  Kind kind;
  Fill{in}(kind);
  return kind;
}

struct Known {
  std::string_view event;
  Happening (*filled)(Fields&);
};

constexpr std::array<Known, 30> kKnown{{
    {"enemy_created", filled<EnemyCreated>},
    {"enemy_intercepted", filled<EnemyIntercepted>},
    {"target_hit", filled<TargetHit>},
    {"collision", filled<Collision>},
    {"robot_lost", filled<RobotLost>},
    {"robot_back", filled<RobotBack>},
    {"robot_late", filled<RobotLate>},
    {"checkpoint", filled<Checkpoint>},
    {"run_ended", filled<RunEnded>},
    {"enemy_retreated", filled<EnemyRetreated>},
    {"mine_taken", filled<MineTaken>},
    {"mine_dropped", filled<MineDropped>},
    {"mine_stored", filled<MineStored>},
    {"robot_disabled", filled<RobotDisabled>},
    {"robot_revived", filled<RobotRevived>},
    {"mission_over", filled<MissionOver>},
    {"forage_begun", filled<ForageBegun>},
    {"operation_begun", filled<OperationBegun>},
    {"object_taken", filled<ObjectTaken>},
    {"object_dropped", filled<ObjectDropped>},
    {"object_stored", filled<ObjectStored>},
    {"object_tested", filled<ObjectTested>},
    {"doorway_marked", filled<DoorwayMarked>},
    {"site_entered", filled<SiteEntered>},
    {"point_reached", filled<PointReached>},
    {"signalled", filled<Signalled>},
    {"alerted", filled<Alerted>},
    {"robot_exposed", filled<RobotExposed>},
    {"robot_finished", filled<RobotFinished>},
    {"operator_acted", filled<OperatorActed>},
}};
static_assert(kKnown.size() == std::variant_size_v<Happening>);

}  // namespace

std::optional<Event> event_in(std::string_view line) {
  Event event;
  Fields in(line);
  in.number("tick", event.tick);
  const std::string_view called = in.text("event");
  const auto* const known = std::find_if(kKnown.begin(), kKnown.end(),
                                         [&](const Known& each) { return each.event == called; });
  if (known == kKnown.end()) return std::nullopt;
  event.what = known->filled(in);
  // A number can be spelled in many ways, a log in one.
  return in.done() && to_line(event) == line ? std::optional(event) : std::nullopt;
}

void read_events(const std::filesystem::path& file, const std::function<void(const Event&)>& take) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file)) {
    throw RecordError(file, "cannot be read, wanted an event log");
  }
  std::uint64_t number = 0;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    ++number;
    const std::optional<Event> event = event_in(line);
    if (!event) {
      throw RecordError(file, "line " + std::to_string(number) + ": found " + line.substr(0, 120) +
                                  ", wanted an event as Tacit writes it");
    }
    take(*event);
  }
  if (in.bad()) {
    throw RecordError(file, system_reason());
  }
}

}  // namespace tacit
