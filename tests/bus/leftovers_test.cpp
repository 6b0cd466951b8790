#include "idl/bus/leftovers.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <fstream>

#include "idl/bus/publisher.h"
#include "idl/bus/subscriber.h"
#include "tests/bus/runs.h"

namespace tacit {
namespace {

/// Runs an agent in a process of its own, which says when its endpoints are there and is then
/// killed.
void run_agent_and_kill_it(const Identity& identity) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    Participant agent(identity);
    Publisher<topics::Command> commands(agent, identity.robot);
    Bell bell;
    Mailbox<Percept> mailbox(bell);
    Subscriber<topics::Percept> percepts(agent, identity.robot, mailbox);
    [[maybe_unused]] const ssize_t told = write(ready[1], "x", 1);
    for (;;) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(ready[0]);
  close(ready[1]);
}

TEST(Leftovers, OfAKilledAgentAreFoundAndRemoved) {
  const test::Run run;
  run_agent_and_kill_it(run.agent(1));
  const auto left = leftovers(run.nonce());
  EXPECT_GE(left.size(), 1U);
  EXPECT_EQ(remove_leftovers(run.nonce()), left.size());
  EXPECT_TRUE(leftovers(run.nonce()).empty());
}

TEST(Leftovers, OfAnotherRunStay) {
  const test::Run mine;
  const test::Run other;
  run_agent_and_kill_it(other.agent(1));
  const auto before = leftovers(other.nonce());
  ASSERT_FALSE(before.empty());
  remove_leftovers(mine.nonce());
  EXPECT_EQ(leftovers(other.nonce()), before);
}

TEST(Leftovers, DoNotIncludeFilesOfAnotherKind) {
  const test::Run run;
  const std::filesystem::path stranger = "/dev/shm/tacit_test_01.0f." + std::to_string(run.nonce());
  std::ofstream(stranger) << "x";
  remove_leftovers(run.nonce());
  EXPECT_TRUE(std::filesystem::remove(stranger));
}

TEST(Leftovers, OfARunWhoseLauncherWasKilledGoWithTheNextLease) {
  char name[] = "/tmp/tacit-leases-XXXXXX";
  const std::filesystem::path folder = mkdtemp(name);
  const test::Run run;
  run_agent_and_kill_it(run.agent(1));
  ASSERT_FALSE(leftovers(run.nonce()).empty());
  const pid_t launcher = fork();
  if (launcher == 0) {
    const DomainLease lease = DomainLease::take(run.nonce(), folder);
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(launcher, &status, 0);
  const DomainLease next = DomainLease::take(run.nonce() + 1, folder);
  EXPECT_TRUE(leftovers(run.nonce()).empty());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace tacit
