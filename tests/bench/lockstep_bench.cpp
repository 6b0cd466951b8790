// How near lock-step over DDS comes to the fastest exchange that the machine can do.
//
// Each sample of the product is a world server and N robot agents, real brains and all, on the
// guard scenario at full speed. Each sample of the floor is one process that exchanges messages of
// the same size with N others over raw Unix sockets and does nothing else. Samples take turns, so
// that a busy machine hurts both alike.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "deploy/lockstep/setup.h"
#include "idl/bus/domain_lease.h"
#include "idl/bus/leftovers.h"
#include "idl/bus/mailbox.h"
#include "idl/bus/subscriber.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::size_t kPerceptBytes = 1024;
constexpr std::size_t kCommandBytes = 64;
constexpr Seconds kWarmUp{0.4};

struct Wish {
  int samples = 5;
  Seconds length{2.0};
  std::vector<int> team_sizes{1, 2, 6, 12};
};

void require(bool good, const char* what) {
  if (!good) throw std::runtime_error(what);
}

/// The robot's half of the floor.
[[noreturn]] void echo(int socket) {
  std::array<char, kPerceptBytes> percept{};
  std::array<char, kCommandBytes> command{};
  while (recv(socket, percept.data(), percept.size(), 0) > 0) {
    if (send(socket, command.data(), command.size(), MSG_NOSIGNAL) < 0) break;
  }
  _exit(0);
}

void exchange_once(const std::vector<int>& sockets) {
  static std::array<char, kPerceptBytes> percept{};
  static std::array<char, kCommandBytes> command{};
  for (const int socket : sockets) {
    require(send(socket, percept.data(), percept.size(), 0) > 0, "a partner has died");
  }
  for (const int socket : sockets) {
    require(recv(socket, command.data(), command.size(), 0) > 0, "a partner has died");
  }
}

/// Ticks a second of raw Unix sockets between this process and `robots` others.
double floor_rate(int robots, Seconds length) {
  std::vector<int> sockets;
  for (int i = 0; i < robots; ++i) {
    std::array<int, 2> pair{};
    require(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) == 0, "socketpair");
    if (fork() == 0) {
      for (const int other : sockets) close(other);
      close(pair[0]);
      echo(pair[1]);
    }
    close(pair[1]);
    sockets.push_back(pair[0]);
  }
  const auto begun = Clock::now();
  std::uint64_t ticks = 0;
  for (; Clock::now() - begun < length; ++ticks) exchange_once(sockets);
  const Seconds took = Clock::now() - begun;
  for (const int socket : sockets) close(socket);
  for (int i = 0; i < robots; ++i) wait(nullptr);
  return static_cast<double>(ticks) / took.count();
}

pid_t start(const std::vector<std::string>& words) {
  const pid_t child = fork();
  if (child != 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

/// The guard scenario with another team size and without an end in sight.
fs::path scenario_for(int robots, const fs::path& folder) {
  ScenarioFile file = ScenarioFile::read(TACIT_SOURCE_DIR "/deploy/scenarios/guard.toml");
  file.set("robots.count", std::to_string(robots));
  file.set("run.duration_s", "1000000.0");
  Setup setup = read_setup(file);
  const fs::path path = folder / ("guard-" + std::to_string(robots) + ".toml");
  std::ofstream(path) << to_toml(describing(setup));
  return path;
}

/// The processes of one run, ended with this object.
class Processes {
 public:
  Processes(const fs::path& scenario, int robots, int domain, std::uint32_t nonce) {
    std::array<char, 9> hex{};
    std::snprintf(hex.data(), hex.size(), "%x", nonce);
    const std::vector<std::string> place{"--scenario",           scenario,      "--domain",
                                         std::to_string(domain), "--run-nonce", hex.data()};
    add("world_server", {}, place);
    for (int id = 1; id <= robots; ++id) add("robot_agent", {"--id", std::to_string(id)}, place);
  }
  ~Processes() {
    for (const pid_t pid : pids_) kill(pid, SIGTERM);
    for (const pid_t pid : pids_) waitpid(pid, nullptr, 0);
  }
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

 private:
  void add(const char* program, std::vector<std::string> words,
           const std::vector<std::string>& place) {
    words.insert(words.begin(), std::string(TACIT_BIN_DIR "/") + program);
    words.insert(words.end(), place.begin(), place.end());
    pids_.push_back(start(words));
  }

  std::vector<pid_t> pids_;
};

/// Hears how far the run has come.
class Listener {
 public:
  explicit Listener(const Identity& identity)
      : participant_(identity), status_(participant_, {}, mailbox_) {}

  /// The first status from `tick_wall_s` seconds after the first tick on.
  RunStatus status_at(double tick_wall_s) {
    const auto until = Clock::now() + std::chrono::seconds(60);
    while (Clock::now() < until) {
      bell_.wait_until(until);
      for (const RunStatus& status : mailbox_.collect()) {
        if (status.phase == RunPhase::Running && status.wall_s >= tick_wall_s) return status;
      }
    }
    throw std::runtime_error("the run does not get going");
  }

 private:
  Bell bell_;
  Mailbox<RunStatus> mailbox_{bell_};
  Participant participant_;
  Subscriber<topics::Status> status_;
};

/// Ticks a second of the product.
double product_rate(const fs::path& scenario, int robots, Seconds length) {
  const std::uint32_t nonce = std::random_device{}();
  const DomainLease lease = DomainLease::take(nonce);
  double rate = 0.0;
  {
    Listener listener({Party::Launcher, {}, lease.domain(), nonce, 1});
    const Processes processes(scenario, robots, lease.domain(), nonce);
    const RunStatus first = listener.status_at(kWarmUp.count());
    const RunStatus last = listener.status_at(kWarmUp.count() + length.count());
    rate = static_cast<double>(last.tick - first.tick) / (last.wall_s - first.wall_s);
  }
  remove_leftovers(nonce);
  return rate;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_header() {
  std::printf("%6s %18s %18s %7s\n", "robots", "floor [ticks/s]", "product [ticks/s]", "ratio");
}

void run(const Wish& wish) {
  const fs::path folder = fs::temp_directory_path() / ("tacit-bench-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::map<int, std::vector<double>> floors;
  std::map<int, std::vector<double>> products;
  std::map<int, std::vector<double>> ratios;
  for (int sample = 0; sample < wish.samples; ++sample) {
    for (const int robots : wish.team_sizes) {
      floors[robots].push_back(floor_rate(robots, wish.length));
      products[robots].push_back(product_rate(scenario_for(robots, folder), robots, wish.length));
      ratios[robots].push_back(products[robots].back() / floors[robots].back());
      std::fprintf(stderr, "sample %d: %2d robots: %8.0f %8.0f\n", sample + 1, robots,
                   floors[robots].back(), products[robots].back());
    }
  }
  fs::remove_all(folder);
  std::printf("Medians of %d samples of %.1f s each, taken in turn.\n", wish.samples,
              wish.length.count());
  print_header();
  for (const int robots : wish.team_sizes) {
    std::printf("%6d %18.0f %18.0f %7.2f\n", robots, median(floors[robots]),
                median(products[robots]), median(ratios[robots]));
  }
}

}  // namespace
}  // namespace tacit

int main(int argc, char** argv) {
  tacit::Wish wish;
  if (argc > 1 && std::string(argv[1]) == "--help") {
    std::printf("usage: lockstep_bench [SAMPLES [SECONDS [ROBOTS...]]]\n");
    return 0;
  }
  if (argc > 1) wish.samples = std::max(1, std::atoi(argv[1]));
  if (argc > 2) wish.length = tacit::Seconds(std::max(0.1, std::atof(argv[2])));
  if (argc > 3) wish.team_sizes.clear();
  for (int i = 3; i < argc; ++i) wish.team_sizes.push_back(std::max(1, std::atoi(argv[i])));
  try {
    tacit::run(wish);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lockstep_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
