#include "idl/bus/venue_file.h"

#include <fstream>

namespace tacit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "live";

}  // namespace

VenueFile::VenueFile(const fs::path& run_directory, const Venue& venue)
    : file_(run_directory / kName) {
  std::ofstream out(file_);
  out << venue.domain << ' ' << venue.run_nonce << '\n';
}

VenueFile::~VenueFile() {
  std::error_code error;
  fs::remove(file_, error);
}

std::optional<Venue> VenueFile::read(const fs::path& run_directory) {
  std::ifstream in(run_directory / kName);
  Venue venue;
  if (in >> venue.domain >> venue.run_nonce) return venue;
  return std::nullopt;
}

}  // namespace tacit
