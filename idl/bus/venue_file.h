#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace tacit {

/// Where on the bus a run takes place.
struct Venue {
  int domain = 1;
  std::uint32_t run_nonce = 0;
  friend bool operator==(const Venue&, const Venue&) = default;
};

/// Says in a run's directory, while the run is on, where on the bus it takes place, so that others
/// can find it: the file `live`, with domain and nonce.
class VenueFile {
 public:
  /// A file that cannot be written is no reason not to run.
  VenueFile(const std::filesystem::path& run_directory, const Venue& venue);
  ~VenueFile();
  VenueFile(const VenueFile&) = delete;
  VenueFile& operator=(const VenueFile&) = delete;

  /// Of the run that is kept there; empty when none is on.
  [[nodiscard]] static std::optional<Venue> read(const std::filesystem::path& run_directory);

 private:
  std::filesystem::path file_;
};

}  // namespace tacit
