#include "tests/cdl/missionlab_samples.h"

#include <gtest/gtest.h>

#include "idl/cdl/parse.h"
#include "idl/cdl/resolve.h"
#include "tests/cdl/laws.h"

namespace tacit::cdl {
namespace {

class MissionLabSamples : public testing::Test {
 protected:
  void SetUp() override {
    samples_ = missionlab_samples();
    if (samples_.empty()) {
      GTEST_SKIP() << "no .cdl files of MissionLab; TACIT_MISSIONLAB_SAMPLES names their folder";
    }
  }
  std::vector<SampleFile> samples_;
};

TEST_F(MissionLabSamples, ParseWithoutError) {
  for (const SampleFile& sample : samples_) {
    for (const Finding& finding : parse(sample.text).findings) {
      ADD_FAILURE() << to_text(finding, sample.name);
    }
  }
}

TEST_F(MissionLabSamples, HaveRobotsWithActuators) {
  for (const SampleFile& sample : samples_) {
    const Resolved resolved = resolve(parse(sample.text).mission);
    ASSERT_FALSE(resolved.robots.empty()) << sample.name;
    EXPECT_FALSE(resolved.robots.front().actuators.empty()) << sample.name;
    EXPECT_TRUE(resolved.findings.empty()) << sample.name;
  }
}

TEST_F(MissionLabSamples, KeepTheLawsOfReadingAndPrinting) {
  for (const SampleFile& sample : samples_) {
    EXPECT_EQ(broken_law(sample.text), "") << sample.name;
  }
}

}  // namespace
}  // namespace tacit::cdl
