#include "console/mcap/writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "console/mcap/compression.h"

namespace tacit {
namespace {

using namespace mcap;

constexpr mode_t kReadableByAll = 0644;

std::string system_reason() { return std::generic_category().message(errno); }

/// Appends the records of one kind and where they are.
template <class Records>
void append_group(Bytes& summary, Bytes& offsets, std::uint64_t start, Op op,
                  const Records& records) {
  const std::uint64_t begin = summary.size();
  for (const auto& record : records) append(summary, record);
  if (summary.size() > begin) {
    append_summary_offset(offsets, op, start + begin, summary.size() - begin);
  }
}

}  // namespace

McapWriter::McapWriter(std::filesystem::path file, Setting setting)
    : file_(std::move(file)), setting_(std::move(setting)) {
  fd_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kReadableByAll);
  if (fd_ < 0) throw McapError(file_, system_reason());
  record_.assign(kMagic.begin(), kMagic.end());
  append_header(record_, "", setting_.library);
  put_record();
}

McapWriter::~McapWriter() {
  if (fd_ >= 0) ::close(fd_);
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding,
                                     std::string_view text) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
  schemas_.push_back({id, std::string(name), std::string(encoding), std::string(text)});
  append(chunk_, schemas_.back());
  return id;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic,
                                      std::string_view encoding) {
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  channels_.push_back({id, schema, std::string(topic), std::string(encoding), {}});
  append(chunk_, channels_.back());
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t log_time_ns, Span data) {
  if (in_chunk_.messages == 0) chunk_begun_ = Clock::now();
  const auto sequence = static_cast<std::uint32_t>(statistics_.of_channel[channel]);
  const Message message{channel, sequence, log_time_ns, log_time_ns, data};
  entries_[channel].emplace_back(log_time_ns, chunk_.size());
  append(chunk_, message);
  in_chunk_.add(message);
  statistics_.add(message);
  if (chunk_.size() >= setting_.chunk_bytes) flush();
}

void McapWriter::attach(const Attachment& attachment) {
  flush();
  append(record_, attachment);
  attachments_.push_back({size_, record_.size(), attachment.log_time_ns, attachment.create_time_ns,
                          attachment.data.size(), attachment.name, attachment.media_type});
  put_record();
}

void McapWriter::note(const Metadata& metadata) {
  flush();
  append(record_, metadata);
  metadata_.push_back({size_, record_.size(), metadata.name});
  put_record();
}

void McapWriter::flush_if_due() {
  if (in_chunk_.messages > 0 && Clock::now() - chunk_begun_ >= setting_.chunk_age) flush();
}

void McapWriter::flush() {
  if (!chunk_.empty()) put_chunk();
}

void McapWriter::put_chunk() {
  compress(chunk_, compressed_);
  const ChunkHead head{in_chunk_.start_ns, in_chunk_.end_ns, chunk_.size(), crc32(chunk_), "zstd"};
  append(record_, head, compressed_);
  ChunkIndex index{head.start_ns, head.end_ns,        size_,        record_.size(), {}, 0,
                   "zstd",        compressed_.size(), chunk_.size()};
  put_message_indexes(index);
  put_record();
  chunks_.push_back(std::move(index));
  chunk_.clear();
  entries_.clear();
  in_chunk_ = {};
}

void McapWriter::put_message_indexes(ChunkIndex& index) {
  for (const auto& [channel, entries] : entries_) {
    index.message_indexes[channel] = size_ + record_.size();
    append_message_index(record_, channel, entries);
  }
  index.message_index_length = record_.size() - index.length;
}

void McapWriter::append_summary(Bytes& summary, Bytes& offsets, std::uint64_t start) const {
  Statistics statistics = statistics_;
  statistics.schemas = static_cast<std::uint16_t>(schemas_.size());
  statistics.channels = static_cast<std::uint32_t>(channels_.size());
  statistics.attachments = static_cast<std::uint32_t>(attachments_.size());
  statistics.metadata = static_cast<std::uint32_t>(metadata_.size());
  statistics.chunks = static_cast<std::uint32_t>(chunks_.size());
  append_group(summary, offsets, start, Op::Schema, schemas_);
  append_group(summary, offsets, start, Op::Channel, channels_);
  append_group(summary, offsets, start, Op::Statistics, std::vector{statistics});
  append_group(summary, offsets, start, Op::ChunkIndex, chunks_);
  append_group(summary, offsets, start, Op::AttachmentIndex, attachments_);
  append_group(summary, offsets, start, Op::MetadataIndex, metadata_);
}

void McapWriter::close() {
  flush();
  append_data_end(record_, crc_.value());
  put_record();
  Bytes summary;
  Bytes offsets;
  append_summary(summary, offsets, size_);
  const std::uint64_t offset_start = size_ + summary.size();
  summary.insert(summary.end(), offsets.begin(), offsets.end());
  ByteWriter into(summary);
  into.number(static_cast<std::uint8_t>(Op::Footer)).number(std::uint64_t{20});
  into.number(size_).number(offset_start);
  into.number(crc32(summary)).bytes(kMagic);
  write_all(summary);
  ::close(std::exchange(fd_, -1));
}

void McapWriter::put_record() {
  write_all(record_);
  crc_.add(record_);
  record_.clear();
}

void McapWriter::write_all(Span bytes) {
  if (fd_ < 0) throw McapError(file_, "is closed");
  const std::uint64_t whole = size_;
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
      size_ += static_cast<std::uint64_t>(written);
    } else if (errno != EINTR) {
      const std::string reason = system_reason();
      // Should this fail too, readers stop at the torn record.
      static_cast<void>(::ftruncate(fd_, static_cast<off_t>(whole)));
      ::close(std::exchange(fd_, -1));
      throw McapError(file_, "cannot be written: " + reason);
    }
  }
}

}  // namespace tacit
