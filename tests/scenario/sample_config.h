#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "idl/scenario/scenario_file.h"
#include "idl/types/config_error.h"

namespace tacit {

/// One parameter of each type.
struct SampleConfig {
  double radius_m = 0.25;
  std::int64_t count = 6;
  bool walls = true;
  std::string learner = "lm";
  std::string note = "plain";
  std::vector<std::vector<double>> discs;
  std::vector<std::string> tags;
};

inline void describe(SampleConfig& config, ParameterVisitor& visitor) {
  static constexpr std::array<std::string_view, 3> kLearners{"static1", "static2", "lm"};
  static constexpr std::array<std::string_view, 3> kColumns{"x", "y", "r"};
  visitor.section("robots", "The team.");
  visitor.number("radius_m", config.radius_m, {0.05, 5.0}, {"m", "Body radius. [ours: a number]"});
  visitor.integer("count", config.count, {1, 1000}, {"", "Team size. [paper]"});
  visitor.flag("walls", config.walls, {"", "Whether walls stand. [ours: a flag]"});
  visitor.section("robots.brain", "The minds.");
  visitor.choice("learner", config.learner, kLearners, {"", "What adapts. [paper]"});
  visitor.text("note", config.note, {"", "For people."});
  visitor.texts("tags", config.tags, {"", "Labels."});
  visitor.rows("discs", config.discs, kColumns, {0, 100}, {"m", "Obstacles. [MissionLab]"});
}

/// What is said about `text` when it is loaded whole; empty when it is fine.
inline std::string complaint(std::string_view text, std::string_view set_path = "",
                             std::string_view set_value = "") {
  try {
    ScenarioFile file = ScenarioFile::parse(text, "team.toml");
    if (!set_path.empty()) {
      file.set(set_path, set_value);
    }
    SampleConfig config;
    file.fill(config);
    file.refuse_unknown_sections();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

inline SampleConfig loaded(std::string_view text) {
  SampleConfig config;
  ScenarioFile::parse(text, "team.toml").fill(config);
  return config;
}

}  // namespace tacit
