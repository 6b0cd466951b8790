#include "wizard_service/cbr/wizard.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "idl/types/config_error.h"
#include "wizard_service/cbr/adapt.h"
#include "wizard_service/cbr/automaton.h"
#include "wizard_service/cbr/criticize.h"
#include "wizard_service/cbr/join.h"
#include "wizard_service/cbr/naive.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/propose.h"
#include "wizard_service/cbr/sites.h"

namespace tacit::cbr {
namespace {

/// What each thing that could not be mended takes from a plan's stars. [ours]
constexpr double kWarningStars = 1.0;

double hundredths(double value) { return std::round(value * 100.0) / 100.0; }

void refuse_outside(const PlanRequest& request, const Terrain& terrain) {
  std::string text;
  const MapExtent extent = terrain.extent();
  for (std::size_t i = 0; i < request.tasks.size(); ++i) {
    const PlacedTask& task = request.tasks[i];
    if (terrain.holds({task.x_m, task.y_m})) continue;
    text += (text.empty() ? "task " : "\ntask ") + std::to_string(i + 1) + ": found (" +
            place_text(task.x_m, task.y_m) + "), wanted a place on the map, from (" +
            place_text(extent.low.x_m, extent.low.y_m) + ") to (" +
            place_text(extent.high.x_m, extent.high.y_m) + ')';
  }
  if (!text.empty()) throw ConfigError(text);
}

std::string value_text(const FeatureRow& row, std::size_t code) {
  return std::string(row.values[code]);
}

std::string record_text(const TrackRecord& record) {
  if (record.outcomes == 0) return {};
  std::string text = number_text(static_cast<double>(record.good_milli) / 1000.0) + " of " +
                     std::to_string(record.outcomes) + " outcomes good";
  if (!record.failures.empty()) {
    const Failure& last = record.failures.back();
    text += "; last failure" + (last.map.empty() ? "" : " on " + last.map) + ": " + last.what;
  }
  return text;
}

double stars_of(const Outline& outline, int warnings) {
  const double stars = static_cast<double>(outline.rank) / static_cast<double>(kStar);
  return std::clamp(hundredths(stars - kWarningStars * warnings), 0.0, 5.0);
}

/// Where tasks begin and the ways there, and what is told of it. Plans for a request mostly differ
/// in their cases alone, so each is looked for once.
class Survey {
 public:
  Survey(const PlanRequest& request, const Terrain& terrain)
      : request_(request), terrain_(terrain) {}

  const std::vector<Site>& of(const Squad& squad, Changes& changes) {
    const auto [at, fresh] = known_.try_emplace({squad.robots, squad.tasks});
    Found& found = at->second;
    if (fresh) found.sites = place_tasks(request_, squad, terrain_, found.changes);
    changes.add(found.changes);
    return found.sites;
  }

 private:
  struct Found {
    std::vector<Site> sites;
    Changes changes;
  };
  const PlanRequest& request_;
  const Terrain& terrain_;
  std::map<std::pair<int, std::vector<std::size_t>>, Found> known_;
};

/// Makes one plan out of an outline.
class Draft {
 public:
  Draft(const PlanRequest& request, const Terrain& terrain, CaseSource& cases, Survey& survey)
      : request_(request), terrain_(terrain), cases_(cases), survey_(survey) {}

  Proposal made(const Outline& outline) {
    Proposal proposal;
    proposal.offered.arrangement = outline.arrangement;
    for (const Squad& squad : outline.squads) {
      add_robots(proposal.plan, squad_plan(outline, squad, proposal.offered));
    }
    tell_speed(proposal.plan);
    criticize(proposal.plan, {request_.max_velocity_mps, enemy_expected()}, changes_);
    proposal.offered.changes = changes_.all();
    proposal.offered.stars = stars(outline);
    return proposal;
  }

 private:
  Plan squad_plan(const Outline& outline, const Squad& squad, OfferedPlan& offered) {
    const std::vector<Site>& sites = survey_.of(squad, changes_);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < squad.tasks.size(); ++i) {
      const std::size_t task = squad.tasks[i];
      const Case& from = cases_.find(outline.cases[task].id);
      offered.cases.push_back(used(from, task, squad));
      pieces.push_back({label(task), std::to_string(task + 1),
                        adapt(from, fit(task, squad, sites[i]), changes_), sites[i]});
    }
    return join(std::move(pieces), terrain_, outline.squads.size() == 1, changes_);
  }

  [[nodiscard]] std::string label(std::size_t task) const {
    return std::string(word(request_.tasks[task].task)) + ' ' + std::to_string(task + 1);
  }

  [[nodiscard]] Fit fit(std::size_t task, const Squad& squad, const Site& site) const {
    const Query query = query_for(request_, request_.tasks[task]);
    return {squad.robots,
            *query.environment,
            request_.max_velocity_mps,
            base_mps(),
            site.at,
            site.outside,
            "Task " + std::to_string(task + 1) + ", " +
                std::string(word(request_.tasks[task].task)) + ','};
  }

  [[nodiscard]] double base_mps() const {
    return hundredths(request_.max_velocity_mps * request_.aggressiveness);
  }

  [[nodiscard]] bool enemy_expected() const {
    return std::any_of(request_.tasks.begin(), request_.tasks.end(), [&](const PlacedTask& task) {
      return task.handles_enemy.value_or(request_.enemy);
    });
  }

  [[nodiscard]] UsedCase used(const Case& from, std::size_t task, const Squad& squad) const {
    UsedCase used{from.id, from.title, task, {}, record_text(from.record)};
    Query query = query_for(request_, request_.tasks[task]);
    query.robots = squad.robots;
    for (const FeatureRow& row : feature_table()) {
      const std::optional<std::size_t> wanted = code(query, row.feature);
      const std::size_t found = code(from.features, row.feature);
      used.features.push_back({std::string(row.name), wanted ? value_text(row, *wanted) : "",
                               value_text(row, found), !wanted || *wanted == found});
    }
    return used;
  }

  void tell_speed(const Plan& plan) {
    const RobotPlan& first = plan.robots.front();
    changes_.adapt("speed", "Max velocity, and that times aggressiveness as the usual speed.", "",
                   number_text(first.max_mps) + " m/s, " + number_text(first.base_mps) + " m/s");
  }

  [[nodiscard]] double stars(const Outline& outline) const {
    int warnings = 0;
    for (const PlanChange& change : changes_.all()) warnings += change.mended ? 0 : 1;
    return stars_of(outline, warnings);
  }

  const PlanRequest& request_;
  const Terrain& terrain_;
  CaseSource& cases_;
  Survey& survey_;
  Changes changes_;
};

std::string headline(const OfferedPlan& offered) {
  std::string text = "Planned from cases. " + offered.arrangement;
  for (const UsedCase& one : offered.cases) {
    text += "\n * Task " + std::to_string(one.task + 1) + ": " + one.title;
  }
  return text;
}

/// Plans that differ in where they come from alone are told once.
bool is_new(const std::vector<Proposal>& proposals, const Proposal& one) {
  return std::none_of(proposals.begin(), proposals.end(),
                      [&](const Proposal& other) { return other.plan == one.plan; });
}

/// Whether there are `most` that nothing with fewer stars than `stars` can come before.
bool are_enough(const std::vector<Proposal>& proposals, std::size_t most, double stars) {
  const auto ahead = std::count_if(proposals.begin(), proposals.end(),
                                   [&](const Proposal& one) { return one.offered.stars >= stars; });
  return static_cast<std::size_t>(ahead) >= most;
}

Answer naive_answer(const PlanRequest& request) {
  Proposal proposal;
  proposal.plan = naive_plan(request);
  proposal.offered.arrangement = "Every robot goes to every task, straight on.";
  proposal.offered.mission = mission_text(proposal.plan);
  return {{std::move(proposal)}, {"The wizard was left out."}};
}

}  // namespace

Answer answer(const PlanRequest& request, const Terrain& terrain, const CaseIndex& index,
              CaseSource& cases, const Progress& progress) {
  refuse_mistakes(request);
  refuse_outside(request, terrain);
  if (request.naive) return naive_answer(request);
  Answer answer;
  const std::vector<Outline> outlines = propose(request, terrain, index, request.top);
  Survey survey(request, terrain);
  std::size_t drawn = 0;
  for (const Outline& outline : outlines) {
    if (progress) {
      progress(static_cast<double>(drawn) / static_cast<double>(outlines.size()),
               "plan " + std::to_string(drawn + 1) + " of " + std::to_string(outlines.size()));
    }
    ++drawn;
    // Outlines come by rank, and without a warning a plan has the stars of its rank.
    if (are_enough(answer.proposals, request.top, stars_of(outline, 0))) break;
    Proposal one = Draft(request, terrain, cases, survey).made(outline);
    if (is_new(answer.proposals, one)) answer.proposals.push_back(std::move(one));
  }
  std::stable_sort(
      answer.proposals.begin(), answer.proposals.end(),
      [](const Proposal& a, const Proposal& b) { return a.offered.stars > b.offered.stars; });
  if (answer.proposals.size() > request.top) answer.proposals.resize(request.top);
  for (Proposal& one : answer.proposals) {
    one.offered.mission = mission_text(one.plan, headline(one.offered));
  }
  if (!request.robots) {
    answer.notes.push_back("No number of robots was asked for; the cases decide.");
  }
  return answer;
}

}  // namespace tacit::cbr
