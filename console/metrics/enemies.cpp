#include "console/metrics/enemies.h"

namespace tacit {

void Enemies::add(const Event& event) {
  if (const auto* creation = std::get_if<EnemyCreated>(&event.what)) {
    created += creation->kind == EnemyKind::Normal ? 1 : 0;
  } else if (const auto* kill = std::get_if<EnemyIntercepted>(&event.what)) {
    intercepted += kill->kind == EnemyKind::Normal ? 1 : 0;
  } else if (std::holds_alternative<TargetHit>(event.what)) {
    ++successful;
  }
}

std::optional<double> Enemies::intercept_percent() const {
  const std::uint64_t resolved = intercepted + successful;
  if (resolved == 0) {
    return std::nullopt;
  }
  return 100.0 * static_cast<double>(intercepted) / static_cast<double>(resolved);
}

std::vector<Metric> Enemies::metrics() const {
  return {{"created", "", "Normal enemies created.", created},
          {"intercepted", "", "Normal enemies destroyed by a robot.", intercepted},
          {"successful", "", "Normal enemies that reached the target.", successful},
          {"intercept_percent", "%", "Intercepted among those intercepted or successful.",
           measured(intercept_percent())}};
}

void DeathDistance::add(const Event& event) {
  if (const auto* kill = std::get_if<EnemyIntercepted>(&event.what)) {
    if (kill->kind == EnemyKind::Normal) {
      ++deaths;
      sum_m += kill->distance_to_target_m;
    }
  } else if (const auto* hit = std::get_if<TargetHit>(&event.what)) {
    ++deaths;
    sum_m += hit->distance_to_target_m;
  }
}

std::optional<double> DeathDistance::mean_m() const {
  return deaths == 0 ? std::nullopt : std::optional(sum_m / static_cast<double>(deaths));
}

std::vector<Metric> DeathDistance::metrics() const {
  return {{"mean_death_distance_m", "m",
           "Mean distance to the target at which normal enemies died, intercepted or successful.",
           measured(mean_m())}};
}

void Decoys::add(const Event& event) {
  if (const auto* creation = std::get_if<EnemyCreated>(&event.what)) {
    created += creation->kind == EnemyKind::Decoy ? 1 : 0;
  } else if (const auto* kill = std::get_if<EnemyIntercepted>(&event.what)) {
    intercepted += kill->kind == EnemyKind::Decoy ? 1 : 0;
  }
}

std::vector<Metric> Decoys::metrics() const {
  return {{"decoys_created", "", "Decoys created.", created},
          {"decoys_intercepted", "", "Decoys destroyed by a robot.", intercepted}};
}

}  // namespace tacit
