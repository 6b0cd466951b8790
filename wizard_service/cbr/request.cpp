#include "wizard_service/cbr/request.h"

#include <cmath>
#include <string>

#include "idl/types/config_error.h"

namespace tacit::cbr {
namespace {

class Mistakes {
 public:
  void add(const std::string& text) { text_ += (text_.empty() ? "" : "\n") + text; }
  void want(double value, double low, double high, const std::string& what) {
    if (value >= low && value <= high) return;
    add(what + ": found " + std::to_string(value) + ", wanted " + std::to_string(low) + " to " +
        std::to_string(high));
  }
  void want(std::size_t value, std::size_t low, std::size_t high, const std::string& what) {
    if (value >= low && value <= high) return;
    add(what + ": found " + std::to_string(value) + ", wanted " + std::to_string(low) + " to " +
        std::to_string(high));
  }
  void refuse() const {
    if (!text_.empty()) throw ConfigError(text_);
  }

 private:
  std::string text_;
};

constexpr double kSlowest = 0.1;
constexpr double kFastest = 1.0;
/// Of a place on a map, in metres.
constexpr double kFarthest = 1e6;

}  // namespace

void refuse_mistakes(const PlanRequest& request) {
  Mistakes mistakes;
  if (request.tasks.empty()) mistakes.add("tasks: found none, wanted at least one on the map");
  if (request.tasks.size() > kMostPlacedTasks) {
    mistakes.want(request.tasks.size(), std::size_t{1}, kMostPlacedTasks, "tasks");
  }
  for (std::size_t i = 0; i < request.tasks.size(); ++i) {
    const std::string name = "task " + std::to_string(i + 1);
    mistakes.want(request.tasks[i].x_m, -kFarthest, kFarthest, name + ", x [m]");
    mistakes.want(request.tasks[i].y_m, -kFarthest, kFarthest, name + ", y [m]");
  }
  if (request.robots && (*request.robots < 1 || *request.robots > kMostPlannedRobots)) {
    mistakes.add("robots: found " + std::to_string(*request.robots) + ", wanted 1 to " +
                 std::to_string(kMostPlannedRobots));
  }
  mistakes.want(request.max_velocity_mps, kSlowest, kFastest, "max velocity [m/s]");
  mistakes.want(request.aggressiveness, kSlowest, kFastest, "aggressiveness");
  mistakes.want(request.top, std::size_t{1}, kMostPlans, "plans");
  mistakes.refuse();
}

Query query_for(const PlanRequest& request, const PlacedTask& task) {
  const CaseFeatures usual = usual_features(task.task);
  Query query;
  query.task = task.task;
  query.robots = request.robots;
  query.localization = task.localization.value_or(usual.localization);
  query.environment = task.environment.value_or(usual.environment);
  query.handles_enemy = task.handles_enemy.value_or(request.enemy || usual.handles_enemy);
  return query;
}

std::vector<CaseFeatures> features_for(const PlanRequest& request) {
  std::vector<CaseFeatures> all;
  for (const PlacedTask& task : request.tasks) {
    CaseFeatures features = usual_features(task.task);
    const Query query = query_for(request, task);
    features.robots = request.robots.value_or(features.robots);
    features.localization = query.localization.value_or(features.localization);
    features.environment = query.environment.value_or(features.environment);
    features.handles_enemy = query.handles_enemy.value_or(features.handles_enemy);
    all.push_back(features);
  }
  return all;
}

}  // namespace tacit::cbr
