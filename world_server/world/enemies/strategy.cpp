#include "world_server/world/enemies/strategy.h"

#include <array>

namespace tacit {
namespace {

constexpr double kEast = 0.0;
constexpr double kNorthEast = 45.0;
constexpr double kNorth = 90.0;
constexpr double kNorthWest = 135.0;
constexpr double kWest = 180.0;
constexpr double kSouthWest = 225.0;
constexpr double kSouth = 270.0;

// Sides, kinds, group sizes and pairing are the paper's; the periods and the number of decoys are
// ours, chosen so that a team of six is neither idle nor overrun (docs/science.md).

// "The first strategy had enemies approaching from north, south, east, and west."
constexpr std::array kFirst{
    Wave{EnemyKind::Normal, kNorth, 1, 10.0},
    Wave{EnemyKind::Normal, kSouth, 1, 10.0},
    Wave{EnemyKind::Normal, kEast, 1, 10.0},
    Wave{EnemyKind::Normal, kWest, 1, 10.0},
};

// "The second had enemies approaching from northwest, west, and southwest."
constexpr std::array kSecond{
    Wave{EnemyKind::Normal, kNorthWest, 1, 8.0},
    Wave{EnemyKind::Normal, kWest, 1, 8.0},
    Wave{EnemyKind::Normal, kSouthWest, 1, 8.0},
};

// "The third had decoy enemies to the west while groups of five normal enemies approached from
// the northeast."
constexpr std::array kThird{
    Wave{EnemyKind::Normal, kNorthEast, 5, 14.0},
    Wave{EnemyKind::Decoy, kWest, 1, 5.0, 2},
};

// "The fourth was similar to the third, except decoys also appeared in the south."
constexpr std::array kFourth{
    Wave{EnemyKind::Normal, kNorthEast, 5, 14.0},
    Wave{EnemyKind::Decoy, kWest, 1, 5.0, 2},
    Wave{EnemyKind::Decoy, kSouth, 1, 5.0, 2},
};

// "The last had enemies coming from all directions, but always in pairs from opposite sides of
// the target object."
constexpr std::array kFifth{
    Wave{EnemyKind::Normal, 0.0, 2, 4.0, 0, true},
};

}  // namespace

std::span<const Wave> strategy_waves(std::int64_t strategy) {
  switch (strategy) {
    case 1:
      return kFirst;
    case 2:
      return kSecond;
    case 3:
      return kThird;
    case 4:
      return kFourth;
    case 5:
      return kFifth;
    default:
      return {};
  }
}

}  // namespace tacit
