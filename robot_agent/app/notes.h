#pragma once

#include <cstdint>
#include <mutex>

#include "robot_agent/app/memory_file.h"
#include "robot_agent/brain/brain.h"

namespace tacit {

/// What a brain leaves to those that come after it, as it was after so many decisions.
struct Note {
  std::uint64_t decisions = 0;
  std::string memory;  ///< As `Brain::memory`, for a process that takes over.
  std::string policy;  ///< As `Brain::policy`, for later runs.
};

[[nodiscard]] Note note_of(const Brain& brain, std::uint64_t decisions);

/// Keeps the newest note of a brain on disk. From any thread.
///
/// Threads may come here in another order than they took their notes in; the decisions tell which
/// is the newest.
class Notes {
 public:
  using Time = MemoryFile::Time;

  /// An empty path keeps nothing.
  Notes(std::filesystem::path memory, std::filesystem::path learned)
      : memory_(std::move(memory)), learned_(std::move(learned)) {}

  /// Whether there is a file for them; without one nobody needs to take a note.
  [[nodiscard]] bool wanted() const;
  /// The memory in its file; none when there is no file.
  [[nodiscard]] std::optional<std::string> load() const;
  [[nodiscard]] bool due(Time now) const;
  /// Writes `note`, unless one of more decisions came before it.
  void save(const Note& note, Time now);

 private:
  mutable std::mutex files_;  ///< Guards what follows; the disk may be slow.
  MemoryFile memory_;
  MemoryFile learned_;
  std::uint64_t newest_ = 0;  ///< Decisions of the newest note.
};

}  // namespace tacit
