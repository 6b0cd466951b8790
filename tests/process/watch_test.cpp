#include <gtest/gtest.h>
#include <signal.h>

#include "tests/process/programs.h"

namespace tacit {
namespace {

TEST(Watch, DrawsARunThatIsOn) {
  const Scratch scratch;
  const std::string runs = scratch / "runs";
  Running run(
      tacit_words({"run", "biohazard_pair.cdl", "--map", "office", "--extra", "sentry", "--speed",
                   "5", "--quiet", "--out", runs + "/mine", "--store", scratch / "runs.db"}));
  ASSERT_TRUE(becomes_true([&] { return !text_of(runs + "/mine/live").empty(); }));
  const Finished picture = tacit({"watch", "--runs", runs, "--once"});
  EXPECT_EQ(picture.exit_code, 0) << picture.err;
  EXPECT_NE(picture.out.find("mine  running  tick "), std::string::npos) << picture.out;
  EXPECT_NE(picture.out.find("robots 3 of 3"), std::string::npos) << picture.out;
  EXPECT_NE(picture.out.find("##########"), std::string::npos) << picture.out;
  EXPECT_NE(picture.out.find("Sentry"), std::string::npos) << picture.out;
  run.send(SIGINT);
  (void)run.finish();
}

TEST(Watch, SaysWhenNothingIsOn) {
  const Scratch scratch;
  const Finished none = tacit({"watch", "--runs", scratch / "runs"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("no run over DDS is on"), std::string::npos) << none.err;
  EXPECT_EQ(tacit({"watch", scratch / "nothing"}).exit_code, 2);
}

}  // namespace
}  // namespace tacit
