#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wizard_service/cbr/join.h"
#include "wizard_service/cbr/plan.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/terrain.h"

namespace tacit::cbr {

/// Builds one robot's automaton out of its parts of the pieces, one after another.
///
/// On the way to a piece whose robots warn each other of enemies it looks out for them already. It
/// says so once when it sees one; having said or heard so, it goes on as it was told, along states
/// of its own, and begins its part with what that does about an enemy.
class Chain {
 public:
  /// Replaces the states of `robot`, which is to live on, as is `terrain`.
  Chain(RobotPlan& robot, const Terrain& terrain, std::size_t place_in_squad);

  /// The way to a piece's site and the state that the piece begins after. `warning` is the word for
  /// an enemy in sight; empty: it does not look out.
  void add_joint(const Piece& piece, const std::string& warning);
  /// The robot's part of a piece. By `release` it hears that the piece is over when its part has no
  /// end, or says so when it ends the piece for all; empty: neither.
  void add_part(const RobotPlan& part, const std::string& release);
  /// After the last piece's part nothing follows.
  void close(bool for_all);

 private:
  using Names = std::map<std::string, std::string>;

  [[nodiscard]] Names names_for(const std::vector<const PlanState*>& states,
                                const std::string& release) const;
  void leave_building(const std::string& number);
  void go(const std::string& number, const MapPoint& from, const MapPoint& to);
  void deploy(const Piece& piece, const MapPoint& from);
  [[nodiscard]] PlanRule there(std::string_view trigger, const MapPoint& goal) const;
  [[nodiscard]] std::vector<Given> given(const MapPoint& from, const MapPoint& to) const;
  void append(std::string label, cdl::Expression what, PlanRule out);
  void append_warned(const std::string& quiet, PlanState warned);
  bool lead_to(std::string_view placeholder, const std::string& target);

  RobotPlan& robot_;
  const Terrain& terrain_;
  std::size_t place_in_squad_;
  std::optional<MapPoint> here_;
  std::string number_;   ///< Of the piece that is being joined.
  std::string warning_;  ///< On the way to it.
};

}  // namespace tacit::cbr
