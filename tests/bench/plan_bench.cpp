// How long a person's program waits for plans: request to answer over DDS on one host, with several
// client processes at once that ask one request after the other, no two of them alike. Beside it,
// in the same run, the same requests answered by a function call: what is left is the way there and
// back and the others' turns.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "idl/bus/domain_lease.h"
#include "idl/bus/wizard_post.h"
#include "wizard_service/app/desk.h"
#include "wizard_service/cases/seed.h"
#include "wizard_service/client/wizard_client.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Wish {
  int requests = 200;  ///< Of each client.
  std::vector<int> clients{1, 10};
};

double ms_since(Clock::time_point began) {
  return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

std::string office() {
  std::ifstream in(fs::path(TACIT_SOURCE_DIR) / "deploy/maps/office.ovl", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Way points through the hallway, then the building, at a speed that nobody else asks for.
AskForPlans request(int client, int number) {
  static const std::string kMap = office();
  AskForPlans ask;
  ask.map = kMap;
  for (int i = 0; i < 3; ++i) {
    const double x_m = 5.0 + (7 * client + 3 * number + 11 * i) % 30;
    ask.request.tasks.push_back({Task::Waypoints, x_m, 22.0, {}, {}, false});
  }
  ask.request.tasks.push_back({Task::Biohazard, 20.0, 22.0, {}, {}, {}});
  ask.request.robots = 1 + number % 2;
  ask.request.enemy = number % 2 == 1;
  ask.request.max_velocity_mps = 0.2 + 0.8 * (client * 1000 + number) / 20'000.0;
  return ask;
}

void require(bool good, const char* what) {
  if (!good) throw std::runtime_error(what);
}

/// A wizard process of its own, gone with this.
class Wizard {
 public:
  Wizard(int domain, const fs::path& cases) {
    const std::string number = std::to_string(domain);
    pid_ = fork();
    if (pid_ == 0) {
      execl(TACIT_BIN_DIR "/wizard_service", "wizard_service", "--domain", number.c_str(),
            "--cases", cases.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    for (int i = 0; i < 1000 && !WizardPost::is_held(domain); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  ~Wizard() {
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
  }
  Wizard(const Wizard&) = delete;
  Wizard& operator=(const Wizard&) = delete;

 private:
  pid_t pid_ = -1;
};

/// A client process: says on `out` that it is ready, waits for a word on `go`, writes how long each
/// request took.
[[noreturn]] void be_client(int domain, int index, int requests, int go, int out) {
  WizardClient client({domain, std::chrono::seconds(30)});
  (void)client.ask(AskForState{});
  double word = 0.0;
  if (write(out, &word, sizeof word) < 0 || read(go, &word, 1) < 1) _exit(1);
  for (int number = 1; number <= requests; ++number) {
    const AskForPlans ask = request(index, number);
    const Clock::time_point began = Clock::now();
    const WizardClient::Reply reply = client.ask(ask);
    const double took = ms_since(began);
    const auto* answer = std::get_if<PlanAnswer>(&reply);
    if (answer == nullptr || answer->plans.empty()) _exit(1);
    if (write(out, &took, sizeof took) < 0) _exit(1);
  }
  _exit(0);
}

double taken(int from) {
  double value = 0.0;
  require(read(from, &value, sizeof value) == sizeof value, "a client has died");
  return value;
}

std::vector<double> waits_over_dds(int domain, int clients, int requests) {
  int out[2];
  int go[2];
  require(pipe(out) == 0 && pipe(go) == 0, "pipe");
  for (int i = 0; i < clients; ++i) {
    if (fork() == 0) be_client(domain, i, requests, go[0], out[1]);
  }
  close(out[1]);
  for (int i = 0; i < clients; ++i) (void)taken(out[0]);
  const std::string words(static_cast<std::size_t>(clients), 'g');
  require(write(go[1], words.data(), words.size()) > 0, "pipe");
  std::vector<double> waits;
  for (int i = 0; i < clients * requests; ++i) waits.push_back(taken(out[0]));
  while (wait(nullptr) > 0 && errno != ECHILD) {
    if (--clients == 0) break;
  }
  for (const int end : {out[0], go[0], go[1]}) close(end);
  return waits;
}

std::vector<double> waits_by_call(const fs::path& file, int requests) {
  cbr::CaseBase base(file);
  Desk desk(base);
  std::vector<double> waits;
  for (int number = 1; number <= requests; ++number) {
    const WizardRequest word{1, static_cast<std::uint64_t>(number), request(0, number)};
    const Clock::time_point began = Clock::now();
    desk.take(word, [](const WizardReply&) {});
    waits.push_back(ms_since(began));
  }
  return waits;
}

double quantile(std::vector<double>& sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(share * last + 0.5)];
}

void tell(const std::string& name, std::vector<double> waits) {
  std::sort(waits.begin(), waits.end());
  std::printf("%-24s %8.2f %8.2f %8.2f %8.2f\n", name.c_str(), quantile(waits, 0.5),
              quantile(waits, 0.9), quantile(waits, 0.99), waits.back());
  std::fflush(stdout);
}

void run(const Wish& wish) {
  std::string folder = (fs::temp_directory_path() / "tacit-plan-bench-XXXXXX").string();
  require(mkdtemp(folder.data()) != nullptr, "mkdtemp");
  const fs::path file = fs::path(folder) / "cases.db";
  {
    cbr::CaseBase base(file);
    cbr::seed_if_new(base, fs::path(TACIT_SOURCE_DIR) / "wizard_service/seed");
  }
  const DomainLease lease = DomainLease::take(kWizardNonce);
  std::printf("request to answer, ms         p50      p90      p99      max\n");
  tell("by a call", waits_by_call(file, wish.requests));
  {
    const Wizard wizard(lease.domain(), file);
    for (const int clients : wish.clients) {
      tell(std::to_string(clients) + (clients == 1 ? " client" : " clients at once"),
           waits_over_dds(lease.domain(), clients, wish.requests));
    }
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace tacit

/// plan_bench [REQUESTS [CLIENTS...]]
int main(int argc, char** argv) {
  tacit::Wish wish;
  if (argc > 1) wish.requests = std::max(1, std::atoi(argv[1]));
  if (argc > 2) wish.clients.clear();
  for (int i = 2; i < argc; ++i) wish.clients.push_back(std::max(1, std::atoi(argv[i])));
  try {
    tacit::run(wish);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plan_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
