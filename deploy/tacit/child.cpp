#include "deploy/tacit/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <system_error>
#include <utility>

#include "deploy/tacit/signals.h"

namespace tacit {
namespace {

std::vector<char*> arguments_of(const Program& program) {
  std::vector<char*> list{const_cast<char*>(program.binary.c_str())};
  for (const std::string& argument : program.arguments) {
    list.push_back(const_cast<char*>(argument.c_str()));
  }
  list.push_back(nullptr);
  return list;
}

int open_log(const Program& program) {
  if (program.log.empty()) {
    return STDERR_FILENO;
  }
  const int log = open(program.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0) {
    throw std::system_error(errno, std::generic_category(), program.log.string());
  }
  return log;
}

/// In the child, after fork: only calls that are safe there.
[[noreturn]] void become(char* const* arguments, int log, int failure, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  Signals::restore_in_child();
  if (getppid() != parent) {
    _exit(127);
  }
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(arguments[0], arguments);
  const int reason = errno;
  [[maybe_unused]] const ssize_t told = write(failure, &reason, sizeof reason);
  _exit(127);
}

/// The errno of a failed start; 0 when the other program runs.
int reason_of_failure(int pipe_end) {
  int reason = 0;
  while (read(pipe_end, &reason, sizeof reason) < 0 && errno == EINTR) {
  }
  return reason;
}

}  // namespace

std::string Death::words() const {
  if (signal != 0) {
    const char* meaning = sigdescr_np(signal);
    return "was killed by signal " + std::to_string(signal) +
           (meaning != nullptr ? " (" + std::string(meaning) + ')' : "");
  }
  return "ended with exit code " + std::to_string(exit_code);
}

Child::Child(const Program& program) {
  std::vector<char*> arguments = arguments_of(program);
  std::array<int, 2> failure{};
  if (pipe2(failure.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const int log = open_log(program);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    become(arguments.data(), log, failure[1], parent);
  }
  const int fork_failure = pid_ < 0 ? errno : 0;
  close(failure[1]);
  if (log != STDERR_FILENO) {
    close(log);
  }
  const int reason = fork_failure != 0 ? fork_failure : reason_of_failure(failure[0]);
  close(failure[0]);
  if (reason != 0) {
    if (running()) {
      waitpid(pid_, nullptr, 0);
    }
    throw std::system_error(reason, std::generic_category(),
                            program.binary.string() + " cannot be started");
  }
}

Child::Child(Child&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  return *this;
}

Child::~Child() {
  if (running()) {
    send(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
}

std::optional<Death> Child::reap() {
  int status = 0;
  if (!running() || waitpid(pid_, &status, WNOHANG) != pid_) {
    return std::nullopt;
  }
  pid_ = -1;
  return WIFSIGNALED(status) ? Death{0, WTERMSIG(status)} : Death{WEXITSTATUS(status), 0};
}

void Child::send(int signal) const {
  if (running() && kill(-pid_, signal) != 0) {
    kill(pid_, signal);
  }
}

std::string last_lines(const std::filesystem::path& log, std::size_t count) {
  std::ifstream in(log);
  std::deque<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
    if (lines.size() > count) {
      lines.pop_front();
    }
  }
  std::string text;
  for (const std::string& line : lines) {
    text += "\n    " + line;
  }
  return text;
}

}  // namespace tacit
