#pragma once

#include <filesystem>
#include <string>

#include "console/record/append_file.h"
#include "idl/types/world_view.h"

namespace tacit {

/// The first line of a file of trajectories, with its newline.
inline constexpr const char* kTrajectoryColumns = "tick,id,kind,x_m,y_m,heading_rad\n";

/// Appends a view's lines.
void append_trajectory_lines(std::string& out, const WorldView& view);

/// Where every body was: CSV with the columns tick,id,kind,x_m,y_m,heading_rad in the world frame.
/// `kind` is robot, normal or decoy; the heading is empty for enemies.
class TrajectoryFile {
 public:
  /// Opens or creates `file` as AppendFile does. Throws RecordError.
  explicit TrajectoryFile(const std::filesystem::path& file);

  /// Throws RecordError when it cannot be written; then nothing of `view` is.
  void append(const WorldView& view);

 private:
  AppendFile file_;
  std::string lines_;
};

}  // namespace tacit
