#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "idl/cdl/finding.h"
#include "idl/cdl/team.h"
#include "idl/cdl/vocabulary.h"
#include "idl/types/frames.h"
#include "idl/types/percept.h"
#include "robot_agent/brain/perception/thing.h"

namespace tacit {

/// The parameters of a behaviour or trigger of a mission, by name and with the vocabulary's
/// defaults. What is missing or does not fit becomes a finding at the behaviour's place, and a
/// value that can be worked with.
class Arguments {
 public:
  Arguments(const cdl::Behaviour& behaviour, cdl::Use use, const cdl::Span& place,
            cdl::Findings& findings)
      : behaviour_(&behaviour), use_(use), place_(place), findings_(&findings) {}

  [[nodiscard]] const std::string& word_of_behaviour() const { return behaviour_->name; }

  [[nodiscard]] bool has(std::string_view name) const { return given(name) != nullptr; }
  [[nodiscard]] double number(std::string_view name) const;
  /// On the map.
  [[nodiscard]] WorldVec point(std::string_view name) const;
  /// One word.
  [[nodiscard]] std::string word(std::string_view name) const;
  [[nodiscard]] Word text(std::string_view name) const;
  /// Classes of things, as `Mines | Enemies`.
  [[nodiscard]] ThingSet things(std::string_view name) const;
  /// In ticks of 0.1 s, for a number of seconds.
  [[nodiscard]] Tick ticks(std::string_view name) const;

  /// Adds an error.
  void refuse(const std::string& what) const;

 private:
  [[nodiscard]] const cdl::Value* given(std::string_view name) const;
  /// What is given, else the vocabulary's default; empty, and a finding, when there is neither.
  [[nodiscard]] std::optional<cdl::Value> value(std::string_view name) const;

  const cdl::Behaviour* behaviour_;
  cdl::Use use_;
  cdl::Span place_;
  cdl::Findings* findings_;
};

/// Seconds in a tick, MissionLab's control rate of 10 Hz.
inline constexpr double kTickS = 0.1;

/// The classes that a mission's word for things means: "Mines", "Enemies", "Home_Base"; empty when
/// there is none of that name.
[[nodiscard]] ThingSet things_called(std::string_view word);
/// How things of that class are painted, when they are all painted alike.
[[nodiscard]] std::optional<Colour> colour_of(ThingSet things);

}  // namespace tacit
