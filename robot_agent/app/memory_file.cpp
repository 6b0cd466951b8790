#include "robot_agent/app/memory_file.h"

#include <spdlog/spdlog.h>

#include <fstream>
#include <iterator>

namespace tacit {

namespace fs = std::filesystem;

std::optional<std::string> MemoryFile::load() const {
  std::ifstream in(path_, std::ios::binary);
  if (!keeps() || !in) return {};
  return std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void MemoryFile::save(const std::string& memory, Time now) {
  next_ = now + kPeriod;
  if (!keeps() || memory == saved_) return;
  fs::path fresh = path_;
  fresh += ".new";
  std::ofstream out(fresh, std::ios::binary | std::ios::trunc);
  out << memory;
  out.close();
  if (!out) return complain("it cannot be written");
  std::error_code error;
  fs::rename(fresh, path_, error);
  if (error) return complain(error.message());
  saved_ = memory;
}

void MemoryFile::complain(const std::string& why) {
  if (complained_) return;
  complained_ = true;
  spdlog::warn("what is learned is not kept: {}: {}", path_.string(), why);
}

}  // namespace tacit
