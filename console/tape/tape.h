#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "console/mcap/writer.h"
#include "console/record/run.h"
#include "console/tape/scenery.h"
#include "idl/types/event_batch.h"
#include "idl/types/roster.h"
#include "idl/types/telemetry.h"
#include "idl/types/world_view.h"

namespace tacit {

/// Records what a run tells people as an MCAP file, sample by sample as they come over the bus:
/// /tacit/world_view, /tacit/status, /tacit/events and /tacit/robot_N/telemetry; beside them
/// /tacit/scene and /tacit/walls for 3D views. Log times are simulated.
///
/// Each method throws McapError; then the file holds what was recorded before, and nothing more may
/// be added. For one thread.
class Tape {
 public:
  using Bytes = std::span<const std::uint8_t>;

  /// Makes `file`, which must not be there. `scenario_toml` is the resolved one.
  Tape(const std::filesystem::path& file, const RunFacts& facts, std::string_view scenario_toml);

  /// `bytes` are the word's on the bus.
  void add(const WorldView& view, Bytes bytes);
  void add(const RunStatus& status, Bytes bytes);
  void add(const EventBatch& batch, Bytes bytes);
  void add(const Telemetry& telemetry, Bytes bytes);
  /// To be called now and then, so that a crash takes little with it.
  void keep() { writer_.flush_if_due(); }
  /// Adds how the run ended, and closes the file.
  void finish(const RunOutcome& outcome);

  [[nodiscard]] const std::filesystem::path& file() const { return writer_.file(); }
  [[nodiscard]] std::uint64_t messages() const { return writer_.statistics().messages; }

 private:
  std::uint16_t channel(std::string_view topic, std::string_view schema, std::string_view text);
  template <class Topic>
  std::uint16_t channel_of(RobotId robot = {});
  [[nodiscard]] std::uint64_t time_of(Tick tick) const;
  void show(const WorldView& view, std::uint64_t time_ns);

  McapWriter writer_;
  Scenery scenery_;
  std::map<std::string, std::uint16_t, std::less<>> schemas_;
  std::uint16_t view_ = 0;
  std::uint16_t status_ = 0;
  std::uint16_t events_ = 0;
  std::uint16_t scene_ = 0;
  std::uint16_t walls_ = 0;
  std::map<RobotId, std::uint16_t> telemetry_;
  std::uint64_t newest_ns_ = 0;
  bool walls_shown_ = false;
};

/// A name beside `file` that is not taken: run.1.mcap for run.mcap. For what was there before.
[[nodiscard]] std::filesystem::path spare_name(const std::filesystem::path& file);

}  // namespace tacit
