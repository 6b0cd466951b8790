#include "robot_agent/app/notes.h"

namespace tacit {

Note note_of(const Brain& brain, std::uint64_t decisions) {
  Note note{decisions, {}, brain.policy()};
  note.memory = brain.memory(note.policy);
  return note;
}

bool Notes::wanted() const { return memory_.keeps() || learned_.keeps(); }

std::optional<std::string> Notes::load() const {
  const std::lock_guard lock(files_);
  return memory_.load();
}

bool Notes::due(Time now) const {
  const std::lock_guard lock(files_);
  return memory_.due(now);
}

void Notes::save(const Note& note, Time now) {
  const std::lock_guard lock(files_);
  if (note.decisions < newest_) return;
  newest_ = note.decisions;
  memory_.save(note.memory, now);
  learned_.save(note.policy, now);
}

}  // namespace tacit
