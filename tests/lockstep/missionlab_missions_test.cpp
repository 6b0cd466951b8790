// MissionLab's own missions on its own maps, where a folder of them is at hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/cdl/missionlab_samples.h"
#include "tests/lockstep/operations.h"

namespace tacit {
namespace {

using testing::carry_out;
using testing::named_text;
using testing::Outcome;

struct Pairing {
  const char* mission;
  const char* map;
  bool ends;  ///< By itself: some go on for ever.
};

std::string name_of(const ::testing::TestParamInfo<Pairing>& pairing) {
  std::string name = pairing.param.mission;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class MissionLabMissions : public ::testing::TestWithParam<Pairing> {};

TEST_P(MissionLabMissions, RunOnTheirMaps) {
  const std::filesystem::path folder = cdl::missionlab_folder();
  if (!std::filesystem::is_directory(folder)) {
    GTEST_SKIP() << "there are no samples of MissionLab's in " << folder;
  }
  OperationWish wish;
  wish.mission = named_text(folder / GetParam().mission);
  wish.map = named_text(folder / GetParam().map);
  const Outcome outcome = carry_out(wish, 1, 20'000);
  EXPECT_EQ(outcome.over, GetParam().ends) << outcome.ticks << " ticks\n" << outcome.told();
  if (GetParam().ends) {
    EXPECT_TRUE(std::any_of(outcome.events.begin(), outcome.events.end(), [](const Event& event) {
      const auto* over = std::get_if<MissionOver>(&event.what);
      return over != nullptr && over->verdict == Verdict::Accomplished;
    }));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Samples, MissionLabMissions,
    ::testing::Values(
        Pairing{"usability_demos-2000_sample_indoor_task1.cdl", "marc.ovl", true},
        Pairing{"usability_demos-2000_sample_eod.cdl", "mars_demos_minefield.ovl", true},
        Pairing{"mars_demos_sample_lm.cdl", "mars_demos_sample_lm.ovl", false},
        Pairing{"mars_demos_sample_qlearn.cdl", "mars_demos_sample_qlearn.ovl", false},
        Pairing{"tmr_demos_Pedestrian.cdl", "overlays_hospital.ovl", false},
        // Comes to a stop, and has no state in which a mission is over.
        Pairing{"usability_demos-1997_Task0_example.cdl", "overlays_Woods1.ovl", false},
        // TerminateObject takes no object away, so it goes round and round.
        Pairing{"ao-fnc_demos_sample_eod.cdl", "ao-fnc_demos_sea-mines.ovl", false},
        Pairing{"usability_demos-1997_Task5_wander.cdl", "overlays_Woods1.ovl", false},
        Pairing{"mlab-2.0_demos_wander.cdl", "overlays_Woods1.ovl", false}),
    name_of);

}  // namespace
}  // namespace tacit
