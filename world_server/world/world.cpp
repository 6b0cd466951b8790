#include "world_server/world/world.h"

#include <cassert>
#include <cstdlib>
#include <utility>

#include "world_server/world/missions/forage.h"
#include "world_server/world/missions/guard.h"
#include "world_server/world/missions/operation.h"
#include "world_server/world/missions/operation_map.h"
#include "world_server/world/stage.h"

namespace tacit {
namespace {

WorldConfig checked(WorldConfig config, const MapPlan& plan) {
  take_ground(plan, config);
  check(config);
  return config;
}

std::unique_ptr<Mission> make_mission(Stage& stage, const MapPlan& plan) {
  switch (stage.config().mission) {
    case MissionKind::Guard:
      return std::make_unique<Guard>(stage);
    case MissionKind::Forage:
      return std::make_unique<Forage>(stage);
    case MissionKind::Operation:
      return std::make_unique<Operation>(stage, plan);
  }
  std::abort();
}

}  // namespace

class World::Impl {
 public:
  Impl(const WorldConfig& config, std::uint64_t seed)
      : Impl(config, seed, operation_plan(config)) {}

  std::span<const Event> step(std::span<const Command> commands) {
    assert(!mission_->over());
    stage_.begin();
    stage_.drive_robots(commands);
    mission_->set_out(stage_);
    done(WorldPhase::Intent);
    stage_.move();
    done(WorldPhase::Motion);
    settle();
    done(WorldPhase::Rules);
    look();
    done(WorldPhase::Sensing);
    return stage_.events();
  }

  bool operate(const Control& control) { return mission_->hear(control); }

  [[nodiscard]] const Stage& stage() const { return stage_; }
  [[nodiscard]] bool over() const { return mission_->over(); }

  [[nodiscard]] std::uint64_t digest() const {
    Digest digest;
    stage_.add_to(digest);
    mission_->add_to(digest, stage_);
    return digest.value();
  }

  void view(WorldView& out) const {
    stage_.show(out);
    mission_->show(out);
  }

  void on_phase(std::function<void(WorldPhase)> observer) { observer_ = std::move(observer); }

 private:
  Impl(const WorldConfig& config, std::uint64_t seed, const MapPlan& plan)
      : stage_(checked(config, plan), seed), mission_(make_mission(stage_, plan)) {
    look();
  }

  void look() {
    stage_.look();
    mission_->perceive(stage_);
  }

  void settle() {
    mission_->settle(stage_);
    stage_.count_tick();
    if (stage_.tick() % static_cast<Tick>(stage_.config().physics.checkpoint_ticks) == 0) {
      stage_.report(stage_.checkpoint(digest()));
    }
    mission_->conclude(stage_);
  }

  void done(WorldPhase phase) const {
    if (observer_) {
      observer_(phase);
    }
  }

  Stage stage_;
  std::unique_ptr<Mission> mission_;
  std::function<void(WorldPhase)> observer_;
};

World::World(const WorldConfig& config, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(config, seed)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

Tick World::tick() const { return impl_->stage().tick(); }
std::span<const Percept> World::percepts() const { return impl_->stage().percepts(); }
std::span<const Event> World::step(std::span<const Command> commands) {
  return impl_->step(commands);
}
bool World::operate(const Control& control) { return impl_->operate(control); }
bool World::over() const { return impl_->over(); }
std::uint64_t World::digest() const { return impl_->digest(); }
void World::view(WorldView& out) const { impl_->view(out); }
void World::on_phase(std::function<void(WorldPhase)> observer) {
  impl_->on_phase(std::move(observer));
}

}  // namespace tacit
