#include "console/record/policy_folder.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "console/record/files.h"
#include "console/record/record_error.h"
#include "idl/types/config_error.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kStart = "robot_";
constexpr std::string_view kEnd = ".json";

/// 0 when the file is no robot's.
std::int64_t robot_of(const std::string& name) {
  if (!name.starts_with(kStart) || !name.ends_with(kEnd)) {
    return 0;
  }
  std::int64_t robot = 0;
  const char* end = name.data() + name.size() - kEnd.size();
  const auto read = std::from_chars(name.data() + kStart.size(), end, robot);
  return read.ec == std::errc{} && read.ptr == end && robot > 0 ? robot : 0;
}

std::string listed(const std::vector<std::int64_t>& robots) {
  std::string text;
  for (const std::int64_t robot : robots) {
    text += (text.empty() ? "" : ", ") + std::to_string(robot);
  }
  return text;
}

}  // namespace

fs::path PolicyFolder::file_of(std::int64_t robot) const {
  return path_ / (std::string(kStart) + std::to_string(robot) + std::string(kEnd));
}

std::vector<fs::path> PolicyFolder::files() const {
  std::vector<fs::path> files;
  for (const std::int64_t robot : robots_there()) {
    files.push_back(file_of(robot));
  }
  return files;
}

std::vector<PolicyText> PolicyFolder::load(std::int64_t robots) const {
  const std::vector<std::int64_t> there = robots_there();
  if (there.empty()) {
    return {};
  }
  if (static_cast<std::int64_t>(there.size()) != robots || there.back() != robots) {
    throw ConfigError(path_.string() + ": holds the policies of robots " + listed(there) +
                      ", wanted those of robots 1 to " + std::to_string(robots) +
                      ", or none to begin anew");
  }
  std::vector<PolicyText> policies;
  for (const std::int64_t robot : there) {
    const fs::path file = file_of(robot);
    try {
      policies.push_back({read_whole_file(file), file.string()});
    } catch (const RecordError& error) {
      throw ConfigError(error.what());
    }
  }
  return policies;
}

void PolicyFolder::save(const std::vector<std::string>& policies) const {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) {
    throw RecordError(path_, error.message());
  }
  for (std::size_t i = 0; i < policies.size(); ++i) {
    write_whole_file(file_of(static_cast<std::int64_t>(i) + 1), policies[i]);
  }
}

std::vector<std::int64_t> PolicyFolder::robots_there() const {
  std::error_code error;
  std::vector<std::int64_t> robots;
  if (fs::exists(path_, error) && !fs::is_directory(path_, error)) {
    throw ConfigError(path_.string() + ": is no folder, wanted one for policies");
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(path_, error)) {
    if (const std::int64_t robot = robot_of(entry.path().filename().string())) {
      robots.push_back(robot);
    }
  }
  std::sort(robots.begin(), robots.end());
  return robots;
}

}  // namespace tacit
