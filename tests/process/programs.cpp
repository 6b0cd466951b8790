#include "tests/process/programs.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace tacit {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kGlance(10);

void redirect(int from, const fs::path& file) {
  const int to = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(to, from);
  close(to);
}

[[noreturn]] void become(const std::vector<std::string>& words, const Limits& limits) {
  if (limits.largest_file) {
    const rlimit limit{*limits.largest_file, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<char*> arguments;
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "tacit-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("there is no folder for temporary files");
  }
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code error;
  fs::remove_all(path_, error);
}

Running::Running(const std::vector<std::string>& words, const Limits& limits) : pid_(fork()) {
  if (pid_ == 0) {
    redirect(STDOUT_FILENO, scratch_ / "out");
    redirect(STDERR_FILENO, scratch_ / "err");
    become(words, limits);
  }
}

Running::~Running() {
  if (!reaped_) {
    send(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
}

void Running::send(int signal) const { kill(pid_, signal); }

std::string Running::said() const { return text_of(scratch_ / "err"); }
std::string Running::printed() const { return text_of(scratch_ / "out"); }

Finished Running::finish(std::chrono::seconds patience) {
  int status = 0;
  const bool ended =
      becomes_true([this, &status] { return waitpid(pid_, &status, WNOHANG) == pid_; }, patience);
  reaped_ = ended;
  const int exit_code = ended && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return {exit_code, text_of(scratch_ / "out"), text_of(scratch_ / "err")};
}

std::string program(const std::string& name) { return TACIT_BIN_DIR "/" + name; }

std::vector<std::string> tacit_words(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program("tacit")};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

Finished tacit(const std::vector<std::string>& arguments, const Limits& limits) {
  return Running(tacit_words(arguments), limits).finish(std::chrono::seconds(120));
}

bool becomes_true(const std::function<bool()>& truth, std::chrono::seconds patience) {
  const Clock::time_point last_moment = Clock::now() + patience;
  while (!truth()) {
    if (Clock::now() > last_moment) {
      return false;
    }
    std::this_thread::sleep_for(kGlance);
  }
  return true;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace tacit
