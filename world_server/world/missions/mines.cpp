#include "world_server/world/missions/mines.h"

#include <cassert>

namespace tacit {

Mines::Mines(std::span<const WorldVec> places_m, std::size_t robots, const BodyGrid& ground)
    : held_(robots), left_(static_cast<std::uint32_t>(places_m.size())), ground_(ground) {
  for (const WorldVec& place : places_m) {
    mines_.push_back({place});
  }
  survey();
}

MineId Mines::take(std::size_t robot, const WorldVec& place_m, double range_m) {
  assert(held_[robot] == MineId{});
  std::size_t nearest = lying_.size();
  double nearest2 = range_m * range_m;
  ground_.near(place_m, range_m, [&](std::size_t i, const WorldVec& at) {
    const double range2 = (at - place_m).squared_norm();
    if (range2 < nearest2 || (range2 == nearest2 && i < nearest)) {
      nearest = i;
      nearest2 = range2;
    }
  });
  if (nearest == lying_.size()) {
    return {};
  }
  const MineId taken = lying_[nearest].mine;
  held_[robot] = taken;
  mines_[taken.value - 1].state = State::Held;
  mines_[taken.value - 1].holder = robot;
  survey();
  return taken;
}

MineId Mines::put_down(std::size_t robot, const WorldVec& place_m) {
  const MineId mine = release(robot, State::Lying);
  mines_[mine.value - 1].place_m = place_m;
  survey();
  return mine;
}

MineId Mines::store(std::size_t robot) {
  --left_;
  return release(robot, State::Stored);
}

MineId Mines::release(std::size_t robot, State state) {
  const MineId mine = held_[robot];
  assert(mine != MineId{});
  held_[robot] = {};
  mines_[mine.value - 1].state = state;
  mines_[mine.value - 1].holder = 0;
  return mine;
}

void Mines::survey() {
  lying_.clear();
  lying_places_m_.clear();
  for (std::size_t i = 0; i < mines_.size(); ++i) {
    if (mines_[i].state == State::Lying) {
      lying_.push_back({MineId{static_cast<std::uint32_t>(i + 1)}, mines_[i].place_m});
      lying_places_m_.push_back(mines_[i].place_m);
    }
  }
  ground_.rebuild(lying_places_m_);
}

void Mines::add_to(Digest& digest) const {
  for (const Mine& mine : mines_) {
    digest.add(mine.place_m.x());
    digest.add(mine.place_m.y());
    digest.add(static_cast<std::uint64_t>(mine.state));
    digest.add(static_cast<std::uint64_t>(mine.holder));
  }
}

}  // namespace tacit
