#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "console/mcap/reader.h"
#include "idl/types/event.h"
#include "idl/types/world_view.h"

namespace tacit {

/// Reads a run back that a Tape has recorded. Throws McapError when the file is none or damaged;
/// one that is cut off is read as far as it goes.
class TapeReader {
 public:
  explicit TapeReader(const std::filesystem::path& file);

  /// The file as such.
  [[nodiscard]] const McapReader& mcap() const { return mcap_; }
  /// A value of the metadata "run" or "outcome"; empty when there is none.
  [[nodiscard]] std::string fact(std::string_view group, const std::string& key) const;

  /// Gives every event to `take`, in the order of the event log, each once.
  void events(const std::function<void(const Event&)>& take) const;
  /// Gives every world view to `take`, in order of time.
  void views(const std::function<void(const WorldView&)>& take) const;

 private:
  template <class Topic, class Take>
  void each(Take&& take) const;

  std::filesystem::path file_;
  McapReader mcap_;
  std::vector<mcap::Metadata> metadata_;
};

}  // namespace tacit
