#include "console/server/job.h"

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/io.hpp>
#include <fstream>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace tacit {
namespace {

namespace fs = std::filesystem;
namespace bp = boost::process;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A Ctrl-C at the console's terminal is meant for the console; and a program begins with signals
/// that come through. One that is to end with us does so also when we are killed.
struct OwnGroup : bp::extend::handler {
  Job::Life life = Job::Life::EndsWithUs;
  explicit OwnGroup(Job::Life how) : life(how) {}
  template <class Executor>
  void on_exec_setup(Executor&) const {
    ::setpgid(0, 0);
    if (life == Job::Life::EndsWithUs) ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
  }
};

bp::child started(const std::vector<std::string>& words, const fs::path& folder, Job::Life life) {
  fs::create_directories(folder);
  try {
    return bp::child(bp::exe = words.front(),
                     bp::args = std::vector<std::string>(words.begin() + 1, words.end()),
                     bp::std_in<bp::null, bp::std_out>(folder / "out").string(),
                     bp::std_err > (folder / "err").string(), OwnGroup(life));
  } catch (const std::system_error& error) {
    throw std::runtime_error(words.front() + ": " + error.code().message());
  }
}

}  // namespace

class Job::Impl {
 public:
  Impl(const std::vector<std::string>& words, fs::path folder, Life life)
      : folder_(std::move(folder)), life_(life), child_(started(words, folder_, life)) {}
  ~Impl() {
    if (life_ == Life::EndsWithUs && running()) {
      ::kill(-child_.id(), SIGKILL);
      child_.wait();
    } else if (running()) {
      child_.detach();
    }
    std::error_code error;
    fs::remove_all(folder_, error);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool running() {
    const std::lock_guard lock(mutex_);
    std::error_code error;
    return child_.valid() && child_.running(error) && !error;
  }
  void interrupt() {
    const std::lock_guard lock(mutex_);
    std::error_code error;
    if (child_.valid() && child_.running(error) && !error) ::kill(child_.id(), SIGINT);
  }
  std::optional<int> exit_code() {
    if (running()) return std::nullopt;
    const std::lock_guard lock(mutex_);
    const int status = child_.native_exit_code();
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }

 private:
  fs::path folder_;
  Life life_;
  std::mutex mutex_;
  bp::child child_;
};

Job::Job(const std::vector<std::string>& words, const fs::path& folder, Life life)
    : impl_(std::make_unique<Impl>(words, folder, life)) {}
Job::~Job() = default;

bool Job::running() { return impl_->running(); }

bool Job::wait(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kLook{10};
  const auto until = std::chrono::steady_clock::now() + patience;
  while (running()) {
    if (std::chrono::steady_clock::now() >= until) return false;
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

void Job::interrupt() { impl_->interrupt(); }
std::optional<int> Job::exit_code() { return impl_->exit_code(); }
std::string Job::out() const { return text_of(impl_->file("out")); }
std::string Job::err() const { return text_of(impl_->file("err")); }

std::string Job::complaint() const {
  constexpr std::string_view kName = "tacit: ";
  std::string text = err();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t at = text.rfind(kName);
  return at == std::string::npos ? text : text.substr(at + kName.size());
}

}  // namespace tacit
