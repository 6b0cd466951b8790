#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "console/mcap/mcap_error.h"
#include "console/mcap/records.h"

namespace tacit {

/// Reads an MCAP file, whole or cut off, ours or somebody else's, without compression or with zstd.
///
/// The summary at the end tells what there is. A file without a sound one is gone through from its
/// beginning, up to where it ends or makes no sense; `trouble` says why. Nothing in a file makes
/// this read outside it or ask for memory without bound. For one thread.
class McapReader {
 public:
  /// Throws McapError when `file` cannot be read or is no MCAP file.
  explicit McapReader(std::filesystem::path file);
  ~McapReader();
  McapReader(const McapReader&) = delete;
  McapReader& operator=(const McapReader&) = delete;

  /// Why the file is not as its writer meant to leave it; empty when it is.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] const std::map<std::uint16_t, mcap::Schema>& schemas() const { return schemas_; }
  [[nodiscard]] const std::map<std::uint16_t, mcap::Channel>& channels() const { return channels_; }
  [[nodiscard]] const mcap::Statistics& statistics() const { return statistics_; }
  [[nodiscard]] const std::vector<mcap::AttachmentIndex>& attachments() const {
    return attachments_;
  }
  /// The channel of that topic.
  [[nodiscard]] std::optional<std::uint16_t> channel(std::string_view topic) const;

  /// Throw McapError when it cannot be read or its checksum is not its own.
  [[nodiscard]] mcap::Attachment attachment(const mcap::AttachmentIndex& index) const;
  [[nodiscard]] std::vector<mcap::Metadata> metadata() const;

  /// Simulated time, both ends included.
  struct Stretch {
    std::uint64_t from_ns = 0;
    std::uint64_t to_ns = ~std::uint64_t{0};
  };
  /// Gives every message in it to `take`, in order of log time, those of one time as they were
  /// written. Throws McapError when a chunk cannot be read or its checksum is not its own.
  void read(Stretch stretch, const std::function<void(const mcap::Message&)>& take) const;
  void read(const std::function<void(const mcap::Message&)>& take) const { read({}, take); }

  /// Whether the checksum over all data is right. Reads the whole file. True for a file that has
  /// none.
  [[nodiscard]] bool data_checksum_holds() const;

 private:
  /// Where messages lie: a chunk, or a message that is in none.
  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;  ///< With the record's head.
    std::uint64_t start_ns = 0;
    std::uint64_t end_ns = 0;
  };
  struct Record {
    mcap::Op op{};
    mcap::Bytes contents;
    std::uint64_t offset = 0;
    std::uint64_t end = 0;  ///< Where the next one begins.
  };
  class Merge;

  [[nodiscard]] mcap::Bytes bytes_at(std::uint64_t offset, std::uint64_t length) const;
  [[nodiscard]] Record record_at(std::uint64_t offset) const;
  /// The messages' records at `place`, decompressed.
  [[nodiscard]] mcap::Bytes contents_of(const Place& place) const;
  void read_summary();
  void take_summary(const Record& record);
  void scan();
  void take_data(const Record& record);
  void take_contents(const Place& place);
  void forget();

  std::filesystem::path file_;
  int fd_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t data_end_ = 0;  ///< Where the summary begins; 0 when there is none.
  std::string trouble_;
  std::map<std::uint16_t, mcap::Schema> schemas_;
  std::map<std::uint16_t, mcap::Channel> channels_;
  mcap::Statistics statistics_;
  std::vector<Place> places_;
  std::vector<mcap::AttachmentIndex> attachments_;
  std::vector<mcap::MetadataIndex> metadata_;
};

}  // namespace tacit
