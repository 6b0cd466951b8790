#include "idl/scenario/run_config.h"

#include <algorithm>
#include <cmath>

namespace tacit {
namespace {

/// Seeds stay below 2^53, so that every JSON reader sees the same number.
constexpr double kLargestSeed = 9007199254740992.0;
constexpr double kYear = 31557600.0;

}  // namespace

void describe(RunConfig& config, ParameterVisitor& visitor) {
  visitor.section("scenario", "What this is.");
  visitor.text("name", config.name, {"", "Short name, used in run directories and tables."});
  visitor.text("description", config.description, {"", "One sentence for people."});
  visitor.choice("mission", config.mission, kMissionNames,
                 {"",
                  "What the team is there for: guard a target [paper, section 2], forage for mines "
                  "[paper, section 3], or carry out a mission file on a map [paper, section 4]. "
                  "Decides which other parameters there are."});
  visitor.section("run", "How long, and with which chance.");
  visitor.integer("seed", config.seed, {0.0, kLargestSeed},
                  {"",
                   "Seed of every stream of chance; the same seed gives the same run. [ours: "
                   "repeatable runs]"});
  visitor.number("duration_s", config.duration_s, {0.0, kYear},
                 {"s", "Simulated time of one run. [ours: the paper is silent]"});
}

Tick last_tick(double duration_s, double tick_s) {
  return static_cast<Tick>(std::max(1.0, std::floor(duration_s / tick_s + 0.5)));
}

}  // namespace tacit
