#pragma once

#include <string>
#include <string_view>

#include "idl/types/command.h"
#include "idl/types/event_batch.h"
#include "idl/types/ids.h"
#include "idl/types/percept.h"
#include "idl/types/plan_answer.h"
#include "idl/types/plan_request.h"
#include "idl/types/roster.h"
#include "idl/types/telemetry.h"
#include "idl/types/world_view.h"

namespace tacit {

/// What a topic promises. How the promise is kept is the bus's affair.
enum class Promise {
  EveryTick,    ///< As fast as can be; a value may be lost and its sender sends it again.
  Answer,       ///< As EveryTick, and a sender killed at any moment does its reader no harm.
  Glimpse,      ///< The newest value, now and then; may be lost and never slows its sender.
  LatestState,  ///< The newest value reaches every reader, also one that comes later.
  MustArrive,   ///< Every value reaches every reader in order, also one that comes later.
  NoGaps,       ///< Every value reaches the readers that are there; the sender waits for them.
  Question,     ///< Of any size; one that its reader was too slow or not there for is asked again.
};

/// The kinds of process: those of a run, and on a domain of their own the wizard and its clients.
enum class Party : unsigned {
  World = 1,
  Agent = 2,
  Console = 4,
  Launcher = 8,
  Wizard = 16,
  Client = 32
};

/// A set of kinds.
struct Parties {
  unsigned bits = 0;
  constexpr Parties(Party party) : bits(static_cast<unsigned>(party)) {}  // NOLINT: a set of one
  [[nodiscard]] constexpr bool contains(Party party) const {
    return (bits & static_cast<unsigned>(party)) != 0;
  }
  friend constexpr Parties operator|(Parties a, Parties b) {
    a.bits |= b.bits;
    return a;
  }
};
constexpr Parties operator|(Party a, Party b) { return Parties(a) | Parties(b); }

/// Whose topic it is: one for each robot ("tacit/robot_<id>/<name>"), one for the team
/// ("tacit/<name>"), or one for each client of the wizard ("tacit/client_<box>/<name>").
enum class Scope { Robot, Team, Client };

/// Where replies to a client go. Two clients may have one box, so each looks for its own.
[[nodiscard]] constexpr RobotId reply_box(std::uint64_t client) {
  return {static_cast<std::uint16_t>(client & 0xffffU)};
}

/// Every topic, once. A process that is not among the writers never writes it.
namespace topics {

struct Percept {
  using Word = tacit::Percept;
  static constexpr std::string_view kName = "percept";
  static constexpr Scope kScope = Scope::Robot;
  static constexpr Promise kPromise = Promise::EveryTick;
  static constexpr Parties kWriters = Party::World;
  static constexpr Parties kReaders = Party::Agent;
};

struct Command {
  using Word = tacit::Command;
  static constexpr std::string_view kName = "command";
  static constexpr Scope kScope = Scope::Robot;
  static constexpr Promise kPromise = Promise::Answer;
  static constexpr Parties kWriters = Party::Agent;
  static constexpr Parties kReaders = Party::World;
};

struct Order {
  using Word = tacit::Order;
  static constexpr std::string_view kName = "order";
  static constexpr Scope kScope = Scope::Robot;
  static constexpr Promise kPromise = Promise::MustArrive;
  static constexpr Parties kWriters = Party::World;
  static constexpr Parties kReaders = Party::Agent;
};

struct Telemetry {
  using Word = tacit::Telemetry;
  static constexpr std::string_view kName = "telemetry";
  static constexpr Scope kScope = Scope::Robot;
  static constexpr Promise kPromise = Promise::Glimpse;
  static constexpr Parties kWriters = Party::Agent;
  static constexpr Parties kReaders = Party::Console;
};

struct Hello {
  using Word = tacit::Hello;
  static constexpr std::string_view kName = "hello";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::MustArrive;
  static constexpr Parties kWriters = Party::Agent;
  static constexpr Parties kReaders = Party::World;
};

struct Events {
  using Word = EventBatch;
  static constexpr std::string_view kName = "events";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::MustArrive;
  static constexpr Parties kWriters = Party::World;
  static constexpr Parties kReaders = Party::Console;
};

/// A few times a second, for people who watch.
struct WorldView {
  using Word = tacit::WorldView;
  static constexpr std::string_view kName = "world_view";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::Glimpse;
  static constexpr Parties kWriters = Party::World;
  static constexpr Parties kReaders = Party::Console;
};

/// Every tick, when trajectories are asked for.
struct Trajectory {
  using Word = tacit::WorldView;
  static constexpr std::string_view kName = "trajectory";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::NoGaps;
  static constexpr Parties kWriters = Party::World;
  static constexpr Parties kReaders = Party::Console;
};

struct Control {
  using Word = tacit::Control;
  static constexpr std::string_view kName = "control";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::MustArrive;
  static constexpr Parties kWriters = Party::Console | Party::Launcher;
  static constexpr Parties kReaders = Party::World;
};

struct Status {
  using Word = RunStatus;
  static constexpr std::string_view kName = "status";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::LatestState;
  static constexpr Parties kWriters = Party::World;
  static constexpr Parties kReaders = Party::Console | Party::Launcher;
};

/// What people, through their programs, ask of the wizard.
struct WizardRequest {
  using Word = tacit::WizardRequest;
  static constexpr std::string_view kName = "wizard/request";
  static constexpr Scope kScope = Scope::Team;
  static constexpr Promise kPromise = Promise::Question;
  static constexpr Parties kWriters = Party::Client;
  static constexpr Parties kReaders = Party::Wizard;
};

/// What the wizard says to it.
struct WizardReply {
  using Word = tacit::WizardReply;
  static constexpr std::string_view kName = "wizard/reply";
  static constexpr Scope kScope = Scope::Client;
  static constexpr Promise kPromise = Promise::LatestState;
  static constexpr Parties kWriters = Party::Wizard;
  static constexpr Parties kReaders = Party::Client;
};

}  // namespace topics

/// Calls `visit(Topic{})` for every topic.
template <class Visit>
void for_each_topic(Visit&& visit) {
  visit(topics::Percept{});
  visit(topics::Command{});
  visit(topics::Order{});
  visit(topics::Telemetry{});
  visit(topics::Hello{});
  visit(topics::Events{});
  visit(topics::WorldView{});
  visit(topics::Trajectory{});
  visit(topics::Control{});
  visit(topics::Status{});
  visit(topics::WizardRequest{});
  visit(topics::WizardReply{});
}

/// "tacit/robot_3/percept", "tacit/events". `robot` counts for a robot's topic and, as a
/// box, for a client's.
[[nodiscard]] std::string topic_name(Scope scope, std::string_view name, RobotId robot);

template <class Topic>
[[nodiscard]] std::string topic_name(RobotId robot = {}) {
  return topic_name(Topic::kScope, Topic::kName, robot);
}

/// "every tick", "glimpse", …
[[nodiscard]] const char* name(Promise promise);

/// What a process of this kind reads and writes, one topic a line; the text of `--interface`.
[[nodiscard]] std::string interface_text(Party party);

}  // namespace tacit
