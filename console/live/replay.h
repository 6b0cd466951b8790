#pragma once

#include <filesystem>
#include <memory>

#include "console/gateway/session.h"

namespace tacit {

/// A recorded run (MCAP) as a session of the gateway: the same channels as when it was live, played
/// by a clock that can be paused, sped up and moved.
///
/// Services, with JSON: "pause", "resume", "speed" (`factor` above 0), "step" (`ticks`, of a tenth
/// of a second each), "seek" (`time_s`). The parameter "replay" holds {"start_s", "end_s",
/// "time_s", "playing", "speed"}, and is told a few times a second.
class Replay {
 public:
  /// Begins paused at the recording's start. Throws McapError when the file is none.
  Replay(std::shared_ptr<gateway::Session> session, const std::filesystem::path& file);
  ~Replay();
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
