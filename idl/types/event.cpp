#include "idl/types/event.h"

#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace tacit {
namespace {

/// Writes one flat JSON object, members in the order given.
class Line {
 public:
  Line(Tick tick, std::string_view event) {
    number("tick", tick);
    text("event", event);
  }
  template <class Number>
  Line& number(std::string_view key, Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    start(key).append(digits.data(), end);
    return *this;
  }
  Line& text(std::string_view key, std::string_view value) {
    start(key).append(1, '"').append(value).append(1, '"');
    return *this;
  }
  Line& flag(std::string_view key, bool value) {
    start(key).append(value ? "true" : "false");
    return *this;
  }
  /// Printable ASCII: quotes and backslashes alone need an escape.
  Line& word(std::string_view key, const Word& value) {
    std::string& out = start(key).append(1, '"');
    for (const char letter : value.text()) {
      if (letter == '"' || letter == '\\') out.append(1, '\\');
      out.append(1, letter);
    }
    out.append(1, '"');
    return *this;
  }
  /// A digest as 16 hexadecimal digits, since JSON readers round large integers.
  Line& digest(std::string_view key, std::uint64_t value) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string hex(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) {
      hex[i] = kDigits[value & 15];
    }
    return text(key, hex);
  }
  std::string done() { return std::move(out_.append(1, '}')); }

 private:
  std::string& start(std::string_view key) {
    return out_.append(out_.empty() ? "{\"" : ",\"").append(key).append("\":");
  }
  std::string out_;
};

struct ToLine {
  Tick tick;

  std::string operator()(const EnemyCreated& e) const {
    return Line(tick, "enemy_created")
        .number("enemy", e.enemy.value)
        .text("kind", name(e.kind))
        .number("x_m", e.position_m.x())
        .number("y_m", e.position_m.y())
        .done();
  }
  std::string operator()(const EnemyIntercepted& e) const {
    return Line(tick, "enemy_intercepted")
        .number("enemy", e.enemy.value)
        .text("kind", name(e.kind))
        .number("robot", e.robot.value)
        .number("distance_to_target_m", e.distance_to_target_m)
        .done();
  }
  std::string operator()(const TargetHit& e) const {
    return Line(tick, "target_hit")
        .number("enemy", e.enemy.value)
        .number("distance_to_target_m", e.distance_to_target_m)
        .done();
  }
  std::string operator()(const Collision& e) const {
    return Line(tick, "collision")
        .number("robot", e.robot.value)
        .text("with", name(e.with))
        .number("other", e.other)
        .done();
  }
  std::string operator()(const RobotLost& e) const {
    return Line(tick, "robot_lost").number("robot", e.robot.value).done();
  }
  std::string operator()(const RobotBack& e) const {
    return Line(tick, "robot_back").number("robot", e.robot.value).done();
  }
  std::string operator()(const RobotLate& e) const {
    return Line(tick, "robot_late").number("robot", e.robot.value).done();
  }
  std::string operator()(const Checkpoint& e) const {
    return Line(tick, "checkpoint")
        .digest("state", e.state_digest)
        .number("enemies", e.enemies)
        .number("mean_distance_to_target_m", e.mean_distance_to_target_m)
        .number("mean_speed_mps", e.mean_speed_mps)
        .done();
  }
  std::string operator()(const RunEnded& e) const {
    return Line(tick, "run_ended").digest("state", e.state_digest).done();
  }
  std::string operator()(const EnemyRetreated& e) const {
    return Line(tick, "enemy_retreated").number("enemy", e.enemy.value).done();
  }
  std::string operator()(const MineTaken& e) const {
    return mine_line("mine_taken", e.robot, e.mine).done();
  }
  std::string operator()(const MineDropped& e) const {
    return mine_line("mine_dropped", e.robot, e.mine)
        .number("x_m", e.position_m.x())
        .number("y_m", e.position_m.y())
        .done();
  }
  std::string operator()(const MineStored& e) const {
    return mine_line("mine_stored", e.robot, e.mine).number("left", e.left).done();
  }
  std::string operator()(const RobotDisabled& e) const {
    return Line(tick, "robot_disabled")
        .number("robot", e.robot.value)
        .text("by", name(e.by))
        .done();
  }
  std::string operator()(const RobotRevived& e) const {
    return Line(tick, "robot_revived")
        .number("robot", e.robot.value)
        .number("by", e.by.value)
        .done();
  }
  std::string operator()(const MissionOver& e) const {
    return Line(tick, "mission_over")
        .text("verdict", name(e.verdict))
        .number("score_ticks", e.score_ticks)
        .done();
  }
  std::string operator()(const ForageBegun& e) const {
    return Line(tick, "forage_begun").number("mines", e.mines).done();
  }

  std::string operator()(const OperationBegun& e) const {
    return Line(tick, "operation_begun").number("team", e.team).number("extras", e.extras).done();
  }
  std::string operator()(const ObjectTaken& e) const {
    return object_line("object_taken", e.robot, e.object).done();
  }
  std::string operator()(const ObjectDropped& e) const {
    return object_line("object_dropped", e.robot, e.object)
        .number("x_m", e.position_m.x())
        .number("y_m", e.position_m.y())
        .done();
  }
  std::string operator()(const ObjectStored& e) const {
    return object_line("object_stored", e.robot, e.object)
        .number("container", e.container.value)
        .done();
  }
  std::string operator()(const ObjectTested& e) const {
    return object_line("object_tested", e.robot, e.object).text("finding", name(e.finding)).done();
  }
  std::string operator()(const DoorwayMarked& e) const {
    return robot_line("doorway_marked", e.robot)
        .number("doorway", e.doorway)
        .flag("marked", e.marked)
        .done();
  }
  std::string operator()(const SiteEntered& e) const {
    return robot_line("site_entered", e.robot)
        .text("site", name(e.site))
        .number("number", e.number)
        .done();
  }
  std::string operator()(const PointReached& e) const {
    return robot_line("point_reached", e.robot).number("point", e.point).done();
  }
  std::string operator()(const Signalled& e) const {
    return robot_line("signalled", e.robot).word("word", e.word).number("heard", e.heard).done();
  }
  std::string operator()(const Alerted& e) const {
    return robot_line("alerted", e.robot).word("word", e.word).done();
  }
  std::string operator()(const RobotExposed& e) const {
    return robot_line("robot_exposed", e.robot)
        .number("to", e.to.value)
        .flag("exposed", e.exposed)
        .done();
  }
  std::string operator()(const RobotFinished& e) const {
    return robot_line("robot_finished", e.robot).done();
  }
  std::string operator()(const OperatorActed& e) const {
    return robot_line("operator_acted", e.robot)
        .text("act", name(e.act))
        .number("x", e.joystick.x())
        .number("y", e.joystick.y())
        .done();
  }

 private:
  [[nodiscard]] Line robot_line(std::string_view event, RobotId robot) const {
    Line line(tick, event);
    line.number("robot", robot.value);
    return line;
  }
  [[nodiscard]] Line object_line(std::string_view event, RobotId robot, ObjectId object) const {
    Line line = robot_line(event, robot);
    line.number("object", object.value);
    return line;
  }
  [[nodiscard]] Line mine_line(std::string_view event, RobotId robot, MineId mine) const {
    Line line(tick, event);
    line.number("robot", robot.value).number("mine", mine.value);
    return line;
  }
};

}  // namespace

const char* name(Finding finding) {
  switch (finding) {
    case Finding::None:
      return "none";
    case Finding::Harmless:
      return "harmless";
    case Finding::Dangerous:
      return "dangerous";
  }
  return "?";
}

const char* name(Site site) {
  switch (site) {
    case Site::Open:
      return "open";
    case Site::Room:
      return "room";
    case Site::Hallway:
      return "hallway";
  }
  return "?";
}

const char* name(OperatorAct act) {
  switch (act) {
    case OperatorAct::Steer:
      return "steer";
    case OperatorAct::LetGo:
      return "let_go";
    case OperatorAct::Proceed:
      return "proceed";
    case OperatorAct::SkipGoal:
      return "skip_goal";
  }
  return "?";
}

const char* name(EnemyKind kind) {
  switch (kind) {
    case EnemyKind::Normal:
      return "normal";
    case EnemyKind::Decoy:
      return "decoy";
    case EnemyKind::Hunter:
      return "hunter";
  }
  return "?";
}

const char* name(Obstruction obstruction) {
  switch (obstruction) {
    case Obstruction::Obstacle:
      return "obstacle";
    case Obstruction::Wall:
      return "wall";
    case Obstruction::Robot:
      return "robot";
    case Obstruction::Enemy:
      return "enemy";
  }
  return "?";
}

const char* name(Mishap mishap) {
  switch (mishap) {
    case Mishap::Mud:
      return "mud";
    case Mishap::Enemy:
      return "enemy";
  }
  return "?";
}

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accomplished:
      return "accomplished";
    case Verdict::TeamLost:
      return "team_lost";
    case Verdict::OutOfTime:
      return "out_of_time";
  }
  return "?";
}

std::string to_line(const Event& event) { return std::visit(ToLine{event.tick}, event.what); }

}  // namespace tacit
