#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "console/mcap/crc32.h"
#include "console/mcap/mcap_error.h"
#include "console/mcap/records.h"

namespace tacit {

/// Writes an MCAP file: chunks compressed with zstd, indexes, a summary, a checksum over
/// everything.
///
/// The file only grows. What has been flushed outlives this process: a file without its end is read
/// by going through it. After an McapError nothing more is written, and the file holds what was
/// written before. For one thread.
class McapWriter {
 public:
  struct Setting {
    std::string library = "tacit";
    std::size_t chunk_bytes = std::size_t{1} << 20;  ///< Uncompressed, at which a chunk is full.
    std::chrono::milliseconds chunk_age{2000};       ///< Wall time at which it is due.
  };

  /// Makes `file`, which must not be there. Throws McapError.
  McapWriter(std::filesystem::path file, Setting setting);
  explicit McapWriter(std::filesystem::path file) : McapWriter(std::move(file), Setting()) {}
  /// Leaves the file without its end unless `close` was called.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Each returns the new id. Throws McapError.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view text);
  std::uint16_t add_channel(std::uint16_t schema, std::string_view topic,
                            std::string_view encoding);

  /// Takes a message; its sequence number counts the channel's. Throws McapError.
  void write(std::uint16_t channel, std::uint64_t log_time_ns, mcap::Span data);
  /// Throws McapError.
  void attach(const mcap::Attachment& attachment);
  /// Throws McapError.
  void note(const mcap::Metadata& metadata);

  /// Writes the chunk under way if it is older than `chunk_age`. To be called now and then, since
  /// messages may stay away. Throws McapError.
  void flush_if_due();
  /// Writes the chunk under way. Throws McapError.
  void flush();
  /// Writes indexes and summary; nothing may follow. Throws McapError.
  void close();

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const mcap::Statistics& statistics() const { return statistics_; }
  /// Bytes in the file.
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// Log time and offset in the chunk of each message.
  using Entries = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

  /// Appends `record_` to the file and to the checksum.
  void put_record();
  void put_chunk();
  void put_message_indexes(mcap::ChunkIndex& index);
  void append_summary(mcap::Bytes& summary, mcap::Bytes& offsets, std::uint64_t start) const;
  void write_all(mcap::Span bytes);

  std::filesystem::path file_;
  Setting setting_;
  int fd_ = -1;
  std::uint64_t size_ = 0;
  mcap::Crc32 crc_;

  mcap::Bytes chunk_;
  mcap::Bytes compressed_;
  mcap::Bytes record_;
  mcap::Statistics in_chunk_;
  Clock::time_point chunk_begun_{};
  std::map<std::uint16_t, Entries> entries_;

  mcap::Statistics statistics_;
  std::vector<mcap::Schema> schemas_;
  std::vector<mcap::Channel> channels_;
  std::vector<mcap::ChunkIndex> chunks_;
  std::vector<mcap::AttachmentIndex> attachments_;
  std::vector<mcap::MetadataIndex> metadata_;
};

}  // namespace tacit
