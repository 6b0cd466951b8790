#include "deploy/tacit/health.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "deploy/tacit/scenario_library.h"
#include "idl/bus/domain_lease.h"
#include "idl/bus/participant.h"
#include "idl/version/version.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Verdict = Check::Verdict;

std::string first_line_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 256> line{};
  if (!pipe || std::fgets(line.data(), line.size(), pipe.get()) == nullptr) {
    return "";
  }
  std::string text = line.data();
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  return text;
}

Check check_program(const std::string& name) {
  const fs::path path = program_folder() / name;
  if (access(path.c_str(), X_OK) != 0) {
    return {name, Verdict::Bad, "not at " + path.string() + "; build it: deploy/build.sh"};
  }
  const std::string said = first_line_of("'" + path.string() + "' --version 2>/dev/null");
  if (said.find(version()) == std::string::npos) {
    return {name, Verdict::Bad,
            "says \"" + said + "\", wanted version " + std::string(version()) + "; build again"};
  }
  return {name, Verdict::Good, said};
}

Check check_shared_memory() {
  std::error_code error;
  const fs::space_info space = fs::space("/dev/shm", error);
  if (error || access("/dev/shm", W_OK) != 0) {
    return {"/dev/shm", Verdict::Bad, "cannot be written; DDS shares memory there"};
  }
  const std::uintmax_t free_mb = space.available / (1024 * 1024);
  return {"/dev/shm", free_mb < 64 ? Verdict::Doubtful : Verdict::Good,
          std::to_string(free_mb) + " MB free" + (free_mb < 64 ? ", 64 MB are better" : "")};
}

/// What DDS programs have left, or are using now.
Check check_leftovers() {
  std::size_t files = 0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/dev/shm", error)) {
    const std::string name = entry.path().filename().string();
    files += name.starts_with("fastrtps_") || name.starts_with("fast_datasharing_") ? 1 : 0;
  }
  return {"DDS files in /dev/shm", files == 0 ? Verdict::Good : Verdict::Doubtful,
          std::to_string(files) + (files == 0 ? "" : "; a run is going on, or one was killed")};
}

Check check_loopback() {
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool works =
      probe >= 0 && bind(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  if (probe >= 0) {
    close(probe);
  }
  return {"loopback network", works ? Verdict::Good : Verdict::Bad,
          works ? "works" : "127.0.0.1 cannot be used; `ip link set lo up`"};
}

Check check_domain() {
  try {
    const DomainLease lease = DomainLease::take(0);
    return {"DDS domain", Verdict::Good, "the next run gets " + std::to_string(lease.domain())};
  } catch (const BusError& error) {
    return {"DDS domain", Verdict::Bad, error.what()};
  }
}

Check check_processors() {
  const unsigned count = std::thread::hardware_concurrency();
  return {"processors", count < 2 ? Verdict::Doubtful : Verdict::Good,
          std::to_string(count) + (count < 2 ? ", two or more are better" : "")};
}

Check check_scenarios() {
  const std::size_t count = scenario_library().size();
  return {"scenarios", count == 0 ? Verdict::Bad : Verdict::Good,
          std::to_string(count) + (count == 0 ? "; set TACIT_SCENARIOS to their folder" : "")};
}

}  // namespace

std::vector<Check> check_machine() {
  return {check_program("world_server"),
          check_program("robot_agent"),
          check_program("console"),
          check_scenarios(),
          check_shared_memory(),
          check_leftovers(),
          check_loopback(),
          check_domain(),
          check_processors()};
}

}  // namespace tacit
