#include "idl/bus/leftovers.h"

#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "idl/bus/identity.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSharedMemory = "/dev/shm";
/// Fast DDS names a segment by its owner: "fast_datasharing_01.0f.….c1_0.0.1.3", twelve dotted
/// bytes of the participant, then those of the endpoint.
constexpr std::string_view kStart = "fast_datasharing_";
constexpr std::size_t kPrefixChars = 12 * 3 - 1;

std::optional<GuidPrefix> prefix_in(std::string_view name) {
  if (!name.starts_with(kStart) || name.size() < kStart.size() + kPrefixChars) return {};
  const char* at = name.data() + kStart.size();
  GuidPrefix prefix{};
  for (std::uint8_t& byte : prefix) {
    if (std::from_chars(at, at + 2, byte, 16).ptr != at + 2) return {};
    at += 3;
  }
  return prefix;
}

bool is_mine(const fs::path& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
}

}  // namespace

std::vector<fs::path> leftovers(std::uint32_t run_nonce) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator at(kSharedMemory, error), end; !error && at != end;
       at.increment(error)) {
    const std::optional<GuidPrefix> prefix = prefix_in(at->path().filename().native());
    if (prefix && of_run(*prefix, run_nonce) && is_mine(at->path())) found.push_back(at->path());
  }
  return found;
}

std::size_t remove_leftovers(std::uint32_t run_nonce) {
  std::size_t removed = 0;
  for (const fs::path& path : leftovers(run_nonce)) {
    std::error_code error;
    if (fs::remove(path, error)) ++removed;
  }
  return removed;
}

}  // namespace tacit
