#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <random>

#include "console/record/run_directory.h"
#include "deploy/lockstep/setup.h"
#include "deploy/tacit/commands.h"
#include "deploy/tacit/say.h"
#include "deploy/tacit/signals.h"
#include "deploy/tacit/watch_picture.h"
#include "idl/bus/participant.h"
#include "idl/bus/publisher.h"
#include "idl/bus/subscriber.h"
#include "idl/bus/venue_file.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr const char* kExamples = R"(Examples:
  tacit watch                       the run that began last of those in runs/ that go on
  tacit watch runs/guard-7-20300131T235959Z
  tacit watch --once > picture.txt

Keys: p pause and go on, . one tick, + and - twice and half as fast, q leaves the run alone.

On the map: # wall, o obstacle, x enemy, * mine, + object, robots by their numbers.

Exit codes: 0 left or the run is over, 2 no run over DDS is on there, 4 the run says nothing.)";

constexpr milliseconds kFrame{200};
constexpr std::chrono::seconds kPatience{10};

struct WatchWish {
  std::string run;
  std::string runs = "runs";
  bool once = false;
};

fs::path newest_live(const fs::path& folder) {
  fs::path newest;
  fs::file_time_type when{};
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::file_time_type began = fs::last_write_time(entry.path() / "live", error);
    if (!error && (newest.empty() || began > when)) {
      newest = entry.path();
      when = began;
    }
  }
  if (newest.empty()) throw ConfigError("no run over DDS is on in " + folder.string());
  return newest;
}

/// Keys come one by one and unseen while it lives, on a terminal.
class Keys {
 public:
  Keys() : on_(isatty(STDIN_FILENO) != 0 && tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!on_) return;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  ~Keys() {
    if (on_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  [[nodiscard]] std::optional<char> next() const {
    char key = 0;
    return on_ && read(STDIN_FILENO, &key, 1) == 1 ? std::optional(key) : std::nullopt;
  }

 private:
  termios before_{};
  bool on_;
};

/// Hears a run; what came is handed out under a lock.
class Watcher {
 public:
  Watcher(const RunDirectory& directory, const Venue& venue)
      : participant_({Party::Console,
                      {},
                      venue.domain,
                      venue.run_nonce,
                      static_cast<std::uint32_t>(std::random_device{}() | 1U)}),
        controls_(participant_),
        views_(participant_, {}, [this](WorldView& view) { take(watched_.view, view); }),
        status_(participant_, {}, [this](RunStatus& status) { take(watched_.status, status); }) {
    ScenarioFile file = ScenarioFile::read(directory.scenario_file());
    const Setup setup = read_setup(file);
    watched_.terrain = make_terrain(setup.world, seed(setup));
    watched_.name = directory.path().filename().string();
    for (std::int64_t robot = 1; robot <= directory.facts().robots; ++robot) {
      telemetry_.emplace_back(participant_, RobotId{static_cast<std::uint16_t>(robot)},
                              [this](Telemetry& one) { take(watched_.telemetry[one.robot], one); });
    }
  }

  [[nodiscard]] Watched now() {
    const std::lock_guard lock(mutex_);
    return watched_;
  }
  [[nodiscard]] bool has_heard() {
    const std::lock_guard lock(mutex_);
    return !watched_.view.robots.empty();
  }
  void say(const Control& control) { controls_.publish(control); }

 private:
  template <class Word>
  void take(Word& into, Word& word) {
    const std::lock_guard lock(mutex_);
    std::swap(into, word);
  }

  std::mutex mutex_;
  Watched watched_;
  Participant participant_;
  Publisher<topics::Control> controls_;
  Subscriber<topics::WorldView> views_;
  Subscriber<topics::Status> status_;
  std::vector<Subscriber<topics::Telemetry>> telemetry_;
};

/// Draws in place, on a screen of its own that goes when this goes.
class Screen {
 public:
  Screen() { std::cout << "\x1b[?1049h\x1b[?25l" << std::flush; }
  ~Screen() { std::cout << "\x1b[?25h\x1b[?1049l" << std::flush; }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void show(const Watched& watched, const std::string& last) {
    winsize size{};
    const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20;
    const int columns = known ? size.ws_col : 80;
    const int rows = known ? size.ws_row : 24;
    std::string text = "\x1b[H";
    for (const char c : watch_picture(watched, columns, rows - 1)) {
      text += c == '\n' ? std::string("\x1b[K\n") : std::string(1, c);
    }
    std::cout << text << last << "\x1b[J" << std::flush;
  }
};

/// The operator's word for a key; `speed` is what was asked for last.
std::optional<Control> control_for(char key, const Watched& watched, double& speed) {
  Control control;
  switch (key) {
    case 'p':
    case ' ':
      control.kind =
          watched.status.phase == RunPhase::Paused ? ControlKind::Resume : ControlKind::Pause;
      return control;
    case '.':
      control.kind = ControlKind::Step;
      return control;
    case '+':
    case '-':
      speed *= key == '+' ? 2.0 : 0.5;
      control.kind = ControlKind::Speed;
      control.speed = speed;
      return control;
    default:
      return std::nullopt;
  }
}

bool is_over(const Watched& watched) {
  return watched.status.phase == RunPhase::Ended || watched.status.phase == RunPhase::Stopped;
}

Exit show_until_left(Watcher& watcher, Signals& signals, const fs::path& run) {
  Watched last;
  {
    const Keys keys;
    Screen screen;
    double speed = 1.0;
    while (!signals.end_wanted()) {
      last = watcher.now();
      screen.show(last, "p pause  . step  + - speed  q leave");
      if (is_over(last) || !VenueFile::read(run)) break;
      signals.wait(kFrame);
      for (std::optional<char> key = keys.next(); key; key = keys.next()) {
        if (*key == 'q') return Exit::Done;
        if (const auto control = control_for(*key, last, speed)) watcher.say(*control);
      }
    }
  }
  std::cout << watch_picture(last, 80, 24) << std::flush;
  return Exit::Done;
}

Exit watch(const WatchWish& wish) {
  const fs::path run = wish.run.empty() ? newest_live(wish.runs) : fs::path(wish.run);
  const std::optional<Venue> venue = VenueFile::read(run);
  if (!venue) throw ConfigError(run.string() + ": no run over DDS is on there");
  Signals signals;
  Watcher watcher(RunDirectory::open(run), *venue);
  const Clock::time_point give_up = Clock::now() + kPatience;
  while (!watcher.has_heard() && !signals.end_wanted()) {
    if (Clock::now() > give_up) {
      say(run.string() + ": the run says nothing");
      return Exit::TimedOut;
    }
    signals.wait(milliseconds(20));
  }
  if (!wish.once && isatty(STDOUT_FILENO) != 0) return show_until_left(watcher, signals, run);
  signals.wait(kFrame);
  std::cout << watch_picture(watcher.now(), 80, 40) << std::flush;
  return Exit::Done;
}

}  // namespace

void add_watch(CLI::App& app, Exit& ending) {
  CLI::App* command = app.add_subcommand("watch", "Show a run that is on, in the terminal");
  const auto wish = std::make_shared<WatchWish>();
  command->add_option("run", wish->run, "Run directory [the newest that is on]");
  command->add_option("--runs", wish->runs, "Folder in which the newest is looked for")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--once", wish->once, "Print one picture and end");
  command->footer(kExamples);
  command->callback([wish, &ending] { ending = watch(*wish); });
}

}  // namespace tacit
