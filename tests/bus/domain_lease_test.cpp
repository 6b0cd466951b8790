#include "idl/bus/domain_lease.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "idl/bus/identity.h"
#include "idl/bus/participant.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

class DomainLeases : public testing::Test {
 protected:
  DomainLeases() {
    char name[] = "/tmp/tacit-leases-XXXXXX";
    folder_ = mkdtemp(name);
  }
  ~DomainLeases() override { fs::remove_all(folder_); }

  [[nodiscard]] DomainLease take() const { return DomainLease::take(1, folder_); }

  fs::path folder_;
};

TEST_F(DomainLeases, AreForDifferentDomains) {
  const DomainLease first = take();
  const DomainLease second = take();
  EXPECT_NE(first.domain(), second.domain());
}

TEST_F(DomainLeases, EndWithTheirHolder) {
  int before = 0;
  {
    const DomainLease lease = take();
    before = lease.domain();
  }
  EXPECT_EQ(take().domain(), before);
}

TEST_F(DomainLeases, EndWhenTheHolderIsKilled) {
  const DomainLease reference = take();
  const pid_t child = fork();
  if (child == 0) {
    const DomainLease held = take();
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(take().domain(), reference.domain() + 1);
}

TEST_F(DomainLeases, SkipADomainWhosePortIsTaken) {
  const int domain = take().domain();
  const int holder = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(discovery_port(domain));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(bind(holder, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_NE(take().domain(), domain);
  close(holder);
}

TEST_F(DomainLeases, SayThatNoneIsFree) {
  std::vector<DomainLease> all;
  try {
    for (;;) all.push_back(take());
  } catch (const BusError& error) {
    EXPECT_NE(std::string(error.what()).find(folder_.string()), std::string::npos);
  }
  EXPECT_LE(all.size(), 100U);
}

TEST_F(DomainLeases, RefuseAFolderOfAnotherKind) {
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW((void)DomainLease::take(1, folder_ / "file"), BusError);
}

TEST_F(DomainLeases, ThatWereMovedEndOnce) {
  DomainLease first = take();
  const int domain = first.domain();
  const DomainLease moved = std::move(first);
  EXPECT_NE(take().domain(), domain);
}

}  // namespace
}  // namespace tacit
