#include "deploy/tacit/profile.h"

#include <numeric>
#include <string>

namespace tacit {
namespace {

/// Of each TeamPhase, in their order.
constexpr std::array<const char*, kTeamPhases> kParts{
    "recording and the rest", "brains decide", "world: intent",
    "world: motion (Bullet)", "world: rules",  "world: sensing"};

}  // namespace

Profile::Profile(Team& team) : team_(team) {
  team_.on_phase([this](TeamPhase phase) { end_of(phase); });
}

Profile::~Profile() { team_.on_phase({}); }

void Profile::end_of(TeamPhase phase) {
  const Clock::time_point now = Clock::now();
  spent_[static_cast<std::size_t>(phase)] += now - last_;
  last_ = now;
  ticks_ += phase == TeamPhase::Decisions ? 1 : 0;
}

Table Profile::table() const {
  const Clock::duration all = std::accumulate(spent_.begin(), spent_.end(), Clock::duration{});
  Table table{"Where the time went",
              {{"part", "part"}, {"us_per_tick", "us per tick", 2}, {"percent", "%", 1}},
              {}};
  for (std::size_t i = 0; i < kTeamPhases && ticks_ > 0; ++i) {
    const double us = std::chrono::duration<double, std::micro>(spent_[i]).count();
    const double share = static_cast<double>(spent_[i].count()) / static_cast<double>(all.count());
    table.rows.push_back({std::string(kParts[i]), us / static_cast<double>(ticks_), 100.0 * share});
  }
  return table;
}

}  // namespace tacit
