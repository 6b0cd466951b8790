#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "console/mcap/bytes.h"

namespace tacit::mcap {

/// The records of an MCAP file (mcap.dev, version 0), as they are written and read back.

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', 0x30, '\r', '\n'};

enum class Op : std::uint8_t {
  Header = 1,
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  Chunk = 6,
  MessageIndex = 7,
  ChunkIndex = 8,
  Attachment = 9,
  AttachmentIndex = 10,
  Statistics = 11,
  Metadata = 12,
  MetadataIndex = 13,
  SummaryOffset = 14,
  DataEnd = 15,
};

/// Op and length, before each record's contents.
inline constexpr std::size_t kRecordHead = 9;
/// Of a footer with its head.
inline constexpr std::size_t kFooterSize = kRecordHead + 20;

struct Schema {
  std::uint16_t id = 0;
  std::string name;
  std::string encoding;
  std::string text;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  ///< 0 for none.
  std::string topic;
  std::string encoding;
  Texts metadata;
};

struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  Span data;  ///< As long as where it was read from.
};

struct Attachment {
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::string name;
  std::string media_type;
  std::string data;
};

struct Metadata {
  std::string name;
  Texts values;
};

/// Where a chunk lies and which times it holds.
struct ChunkIndex {
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< With its head.
  std::map<std::uint16_t, std::uint64_t> message_indexes;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t size = 0;  ///< Uncompressed.
};

struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
};

struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t attachments = 0;
  std::uint32_t metadata = 0;
  std::uint32_t chunks = 0;
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  std::map<std::uint16_t, std::uint64_t> of_channel;  ///< Messages.

  /// Counts one message in.
  void add(const Message& message);
};

struct Footer {
  std::uint64_t summary_start = 0;  ///< 0 when there is no summary.
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;  ///< 0 when there is none.
};

/// What stands in front of a chunk's contents.
struct ChunkHead {
  std::uint64_t start_ns = 0;
  std::uint64_t end_ns = 0;
  std::uint64_t size = 0;
  std::uint32_t crc = 0;
  std::string compression;
};

/// Each appends one whole record.
void append(Bytes& out, const Schema& schema);
void append(Bytes& out, const Channel& channel);
void append(Bytes& out, const Message& message);
void append(Bytes& out, const Attachment& attachment);
void append(Bytes& out, const Metadata& metadata);
void append(Bytes& out, const ChunkIndex& index);
void append(Bytes& out, const AttachmentIndex& index);
void append(Bytes& out, const MetadataIndex& index);
void append(Bytes& out, const Statistics& statistics);
void append(Bytes& out, const ChunkHead& head, Span contents);
void append_header(Bytes& out, std::string_view profile, std::string_view library);
void append_data_end(Bytes& out, std::uint32_t crc);
/// All messages of one channel in a chunk: their times and where in its contents each begins.
void append_message_index(Bytes& out, std::uint16_t channel,
                          const std::vector<std::pair<std::uint64_t, std::uint64_t>>& entries);
void append_summary_offset(Bytes& out, Op group, std::uint64_t start, std::uint64_t length);

/// Each reads a record's contents. Throws TooShort; an attachment whose CRC is not its own is a
/// std::runtime_error.
[[nodiscard]] Schema read_schema(Span contents);
[[nodiscard]] Channel read_channel(Span contents);
[[nodiscard]] Message read_message(Span contents);
[[nodiscard]] Attachment read_attachment(Span contents);
[[nodiscard]] Metadata read_metadata(Span contents);
[[nodiscard]] ChunkIndex read_chunk_index(Span contents);
[[nodiscard]] AttachmentIndex read_attachment_index(Span contents);
[[nodiscard]] MetadataIndex read_metadata_index(Span contents);
[[nodiscard]] Statistics read_statistics(Span contents);
[[nodiscard]] Footer read_footer(Span contents);
/// Leaves `contents` at what is compressed.
[[nodiscard]] ChunkHead read_chunk_head(Span& contents);

}  // namespace tacit::mcap
