#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <thread>

#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "idl/bus/participant.h"
#include "idl/bus/publisher.h"
#include "idl/bus/venue_file.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr const char* kExamples = R"(Examples:
  tacit run biohazard.cdl --map office.ovl --speed 4 --out runs/mine &
  tacit operate runs/mine pause
  tacit operate runs/mine step 10
  tacit operate runs/mine speed 2
  tacit operate runs/mine proceed --robot 1
  tacit operate runs/mine steer 0.5 -0.5 --robot 2     east and south, until let-go
  tacit operate runs/mine let-go --robot 2

Exit codes: 0 the run has taken it, 2 bad input, 4 the run does not answer.)";

constexpr std::chrono::seconds kPatience(5);

struct OperateWish {
  std::string run;
  std::string word;
  std::vector<double> numbers;
  std::uint16_t robot = 0;
};

double number(const OperateWish& wish, std::size_t index, double low, double high,
              const char* wanted) {
  const bool there = index < wish.numbers.size();
  if (there && wish.numbers[index] >= low && wish.numbers[index] <= high) {
    return wish.numbers[index];
  }
  throw ConfigError("operate " + wish.word + ": wanted " + wanted);
}

void refuse_numbers(const OperateWish& wish, std::size_t most) {
  if (wish.numbers.size() > most) {
    throw ConfigError("operate " + wish.word + ": found " + std::to_string(wish.numbers.size()) +
                      " numbers, wanted at most " + std::to_string(most));
  }
}

Control steer(const OperateWish& wish) {
  constexpr const char* kWanted = "how far east and north the joystick is held, -1 to 1 each";
  Control control;
  control.kind = ControlKind::Steer;
  control.joystick = clipped(
      WorldVec{number(wish, 0, -1.0, 1.0, kWanted), number(wish, 1, -1.0, 1.0, kWanted)}, 1.0);
  refuse_numbers(wish, 2);
  return control;
}

Control step(const OperateWish& wish) {
  Control control;
  control.kind = ControlKind::Step;
  if (!wish.numbers.empty()) {
    const double ticks = number(wish, 0, 1.0, 4e9, "a number of ticks from 1 on");
    control.ticks = static_cast<std::uint32_t>(std::floor(ticks));
  }
  refuse_numbers(wish, 1);
  return control;
}

Control speed(const OperateWish& wish) {
  Control control;
  control.kind = ControlKind::Speed;
  control.speed = number(wish, 0, 0.0, 1e6, "times real time; 0 for as fast as it goes");
  refuse_numbers(wish, 1);
  return control;
}

Control plain(const OperateWish& wish, ControlKind kind) {
  refuse_numbers(wish, 0);
  Control control;
  control.kind = kind;
  return control;
}

Control control_of(const OperateWish& wish) {
  if (wish.word == "pause") return plain(wish, ControlKind::Pause);
  if (wish.word == "resume") return plain(wish, ControlKind::Resume);
  if (wish.word == "stop") return plain(wish, ControlKind::Stop);
  if (wish.word == "proceed") return plain(wish, ControlKind::Proceed);
  if (wish.word == "skip-goal") return plain(wish, ControlKind::SkipGoal);
  if (wish.word == "let-go") return plain(wish, ControlKind::LetGo);
  if (wish.word == "step") return step(wish);
  if (wish.word == "speed") return speed(wish);
  return steer(wish);
}

Exit operate(const OperateWish& wish) {
  Control control = control_of(wish);
  control.robot = {wish.robot};
  const auto venue = VenueFile::read(wish.run);
  if (!venue) {
    throw ConfigError(wish.run + ": no run over DDS is on there");
  }
  Participant participant({Party::Launcher,
                           {},
                           venue->domain,
                           venue->run_nonce,
                           static_cast<std::uint32_t>(std::random_device{}() | 1U)});
  Publisher<topics::Control> publisher(participant);
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  while (publisher.readers() == 0 && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const bool taken =
      publisher.readers() > 0 && publisher.publish(control) && publisher.wait_received(kPatience);
  if (taken) return Exit::Done;
  say(wish.run + ": the run does not answer");
  return Exit::TimedOut;
}

}  // namespace

void add_operate(CLI::App& app, Exit& ending) {
  CLI::App* command =
      app.add_subcommand("operate", "Pause, step or speed up a run that is on, or help its robots");
  const auto wish = std::make_shared<OperateWish>();
  command->add_option("run", wish->run, "Run directory of a run that is on")->required();
  command
      ->add_option("word", wish->word,
                   "pause, resume, step [TICKS], speed X, stop; in an operation also proceed, "
                   "skip-goal, steer EAST NORTH and let-go")
      ->required()
      ->check(CLI::IsMember(
          {"pause", "resume", "step", "speed", "stop", "proceed", "skip-goal", "steer", "let-go"}));
  command->add_option("numbers", wish->numbers, "That the word needs");
  command->add_option("--robot", wish->robot, "Whom it is for; 0 is the whole team")
      ->capture_default_str();
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = operate(*wish); });
}

}  // namespace tacit
