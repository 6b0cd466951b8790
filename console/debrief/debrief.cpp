#include "console/debrief/debrief.h"

namespace tacit {

Debrief::Debrief(const MapPlan& plan, const Config& config)
    : scale_(config.tick_s),
      team_(config.team),
      way_points_(plan),
      search_(plan, config.doors),
      mines_(plan) {
  if (config.hostile && config.team >= 2) {
    cover_.emplace(plan, scale_);
    warnings_.emplace(config.team, scale_);
  }
}

void Debrief::add(const Event& event) {
  team_.add(event);
  way_points_.add(event, team_);
  search_.add(event, team_);
  mines_.add(event, team_);
  if (cover_) cover_->add(event, team_);
  if (warnings_) warnings_->add(event, team_);
  if (!over_ && std::holds_alternative<MissionOver>(event.what)) over_ = event;
}

Checklist Debrief::result() const {
  Checklist list;
  way_points_.append_to(list, scale_);
  search_.append_to(list, scale_);
  mines_.append_to(list, scale_);
  if (cover_) cover_->append_to(list);
  if (warnings_) warnings_->append_to(list);
  list.tasks.push_back(ending());
  return list;
}

SubTask Debrief::ending() const {
  SubTask task{"Accomplish the mission", false, "It did not come to an end."};
  if (!over_) return task;
  const std::string at = scale_.at(over_->tick) + '.';
  switch (std::get<MissionOver>(over_->what).verdict) {
    case Verdict::Accomplished:
      task.done = true;
      task.evidence = "Every robot had nothing more to do " + at;
      break;
    case Verdict::TeamLost:
      task.evidence = "Every robot was disabled " + at;
      break;
    case Verdict::OutOfTime:
      task.evidence = "The time ran out " + at;
      break;
  }
  return task;
}

}  // namespace tacit
