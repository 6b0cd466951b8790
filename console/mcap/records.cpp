#include "console/mcap/records.h"

#include <algorithm>

#include "console/mcap/crc32.h"

namespace tacit::mcap {
namespace {

/// Writes one record: its head when made, its length when done.
class Record {
 public:
  Record(Bytes& out, Op op) : out_(out), into(out) {
    into.number(static_cast<std::uint8_t>(op)).number(std::uint64_t{0});
    begin_ = out.size();
  }
  ~Record() {
    const std::uint64_t length = out_.size() - begin_;
    std::memcpy(out_.data() + begin_ - sizeof length, &length, sizeof length);
  }
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  [[nodiscard]] Span contents() const { return Span(out_).subspan(begin_); }

 private:
  Bytes& out_;
  std::size_t begin_ = 0;

 public:
  ByteWriter into;
};

using Counts = std::map<std::uint16_t, std::uint64_t>;

void write_counts(ByteWriter& into, const Counts& counts) {
  into.number(static_cast<std::uint32_t>(counts.size() * 10));
  for (const auto& [key, value] : counts) into.number(key).number(value);
}

Counts read_counts(ByteReader& in) {
  Counts counts;
  for (ByteReader inner(in.sized<std::uint32_t>()); !inner.done();) {
    const auto key = inner.number<std::uint16_t>();
    counts[key] = inner.number<std::uint64_t>();
  }
  return counts;
}

}  // namespace

void Statistics::add(const Message& message) {
  start_ns = messages == 0 ? message.log_time_ns : std::min(start_ns, message.log_time_ns);
  end_ns = std::max(end_ns, message.log_time_ns);
  ++messages;
  ++of_channel[message.channel];
}

void append(Bytes& out, const Schema& schema) {
  Record record(out, Op::Schema);
  record.into.number(schema.id).text(schema.name).text(schema.encoding).text(schema.text);
}

void append(Bytes& out, const Channel& channel) {
  Record record(out, Op::Channel);
  record.into.number(channel.id).number(channel.schema).text(channel.topic).text(channel.encoding);
  record.into.texts(channel.metadata);
}

void append(Bytes& out, const Message& message) {
  Record record(out, Op::Message);
  record.into.number(message.channel).number(message.sequence).number(message.log_time_ns);
  record.into.number(message.publish_time_ns).bytes(message.data);
}

void append(Bytes& out, const Attachment& attachment) {
  Record record(out, Op::Attachment);
  record.into.number(attachment.log_time_ns).number(attachment.create_time_ns);
  record.into.text(attachment.name).text(attachment.media_type);
  record.into.number(std::uint64_t{attachment.data.size()});
  const auto* const data = reinterpret_cast<const std::uint8_t*>(attachment.data.data());
  record.into.bytes({data, attachment.data.size()});
  record.into.number(crc32(record.contents()));
}

void append(Bytes& out, const Metadata& metadata) {
  Record record(out, Op::Metadata);
  record.into.text(metadata.name).texts(metadata.values);
}

void append(Bytes& out, const ChunkIndex& index) {
  Record record(out, Op::ChunkIndex);
  record.into.number(index.start_ns).number(index.end_ns).number(index.offset).number(index.length);
  write_counts(record.into, index.message_indexes);
  record.into.number(index.message_index_length).text(index.compression);
  record.into.number(index.compressed_size).number(index.size);
}

void append(Bytes& out, const AttachmentIndex& index) {
  Record record(out, Op::AttachmentIndex);
  record.into.number(index.offset).number(index.length).number(index.log_time_ns);
  record.into.number(index.create_time_ns).number(index.data_size);
  record.into.text(index.name).text(index.media_type);
}

void append(Bytes& out, const MetadataIndex& index) {
  Record record(out, Op::MetadataIndex);
  record.into.number(index.offset).number(index.length).text(index.name);
}

void append(Bytes& out, const Statistics& statistics) {
  Record record(out, Op::Statistics);
  record.into.number(statistics.messages).number(statistics.schemas).number(statistics.channels);
  record.into.number(statistics.attachments).number(statistics.metadata).number(statistics.chunks);
  record.into.number(statistics.start_ns).number(statistics.end_ns);
  write_counts(record.into, statistics.of_channel);
}

void append(Bytes& out, const ChunkHead& head, Span contents) {
  Record record(out, Op::Chunk);
  record.into.number(head.start_ns).number(head.end_ns).number(head.size).number(head.crc);
  record.into.text(head.compression).number(std::uint64_t{contents.size()}).bytes(contents);
}

void append_header(Bytes& out, std::string_view profile, std::string_view library) {
  Record record(out, Op::Header);
  record.into.text(profile).text(library);
}

void append_data_end(Bytes& out, std::uint32_t crc) {
  Record record(out, Op::DataEnd);
  record.into.number(crc);
}

void append_message_index(Bytes& out, std::uint16_t channel,
                          const std::vector<std::pair<std::uint64_t, std::uint64_t>>& entries) {
  Record record(out, Op::MessageIndex);
  record.into.number(channel).number(static_cast<std::uint32_t>(entries.size() * 16));
  for (const auto& [time, offset] : entries) record.into.number(time).number(offset);
}

void append_summary_offset(Bytes& out, Op group, std::uint64_t start, std::uint64_t length) {
  Record record(out, Op::SummaryOffset);
  record.into.number(static_cast<std::uint8_t>(group)).number(start).number(length);
}

Schema read_schema(Span contents) {
  ByteReader in(contents);
  Schema schema;
  schema.id = in.number<std::uint16_t>();
  schema.name = in.text();
  schema.encoding = in.text();
  schema.text = in.text();
  return schema;
}

Channel read_channel(Span contents) {
  ByteReader in(contents);
  Channel channel;
  channel.id = in.number<std::uint16_t>();
  channel.schema = in.number<std::uint16_t>();
  channel.topic = in.text();
  channel.encoding = in.text();
  channel.metadata = in.texts();
  return channel;
}

Message read_message(Span contents) {
  ByteReader in(contents);
  Message message;
  message.channel = in.number<std::uint16_t>();
  message.sequence = in.number<std::uint32_t>();
  message.log_time_ns = in.number<std::uint64_t>();
  message.publish_time_ns = in.number<std::uint64_t>();
  message.data = in.rest();
  return message;
}

Attachment read_attachment(Span contents) {
  ByteReader in(contents);
  Attachment attachment;
  attachment.log_time_ns = in.number<std::uint64_t>();
  attachment.create_time_ns = in.number<std::uint64_t>();
  attachment.name = in.text();
  attachment.media_type = in.text();
  const Span data = in.sized<std::uint64_t>();
  const Span covered = contents.first(contents.size() - in.rest().size());
  const auto crc = in.number<std::uint32_t>();
  if (crc != 0 && crc != crc32(covered)) {
    throw std::runtime_error("attachment " + attachment.name + ": its checksum is not its own");
  }
  attachment.data.assign(data.begin(), data.end());
  return attachment;
}

Metadata read_metadata(Span contents) {
  ByteReader in(contents);
  std::string name = in.text();
  return {std::move(name), in.texts()};
}

ChunkIndex read_chunk_index(Span contents) {
  ByteReader in(contents);
  ChunkIndex index;
  index.start_ns = in.number<std::uint64_t>();
  index.end_ns = in.number<std::uint64_t>();
  index.offset = in.number<std::uint64_t>();
  index.length = in.number<std::uint64_t>();
  index.message_indexes = read_counts(in);
  index.message_index_length = in.number<std::uint64_t>();
  index.compression = in.text();
  index.compressed_size = in.number<std::uint64_t>();
  index.size = in.number<std::uint64_t>();
  return index;
}

AttachmentIndex read_attachment_index(Span contents) {
  ByteReader in(contents);
  AttachmentIndex index;
  index.offset = in.number<std::uint64_t>();
  index.length = in.number<std::uint64_t>();
  index.log_time_ns = in.number<std::uint64_t>();
  index.create_time_ns = in.number<std::uint64_t>();
  index.data_size = in.number<std::uint64_t>();
  index.name = in.text();
  index.media_type = in.text();
  return index;
}

MetadataIndex read_metadata_index(Span contents) {
  ByteReader in(contents);
  MetadataIndex index;
  index.offset = in.number<std::uint64_t>();
  index.length = in.number<std::uint64_t>();
  index.name = in.text();
  return index;
}

Statistics read_statistics(Span contents) {
  ByteReader in(contents);
  Statistics statistics;
  statistics.messages = in.number<std::uint64_t>();
  statistics.schemas = in.number<std::uint16_t>();
  statistics.channels = in.number<std::uint32_t>();
  statistics.attachments = in.number<std::uint32_t>();
  statistics.metadata = in.number<std::uint32_t>();
  statistics.chunks = in.number<std::uint32_t>();
  statistics.start_ns = in.number<std::uint64_t>();
  statistics.end_ns = in.number<std::uint64_t>();
  statistics.of_channel = read_counts(in);
  return statistics;
}

Footer read_footer(Span contents) {
  ByteReader in(contents);
  Footer footer;
  footer.summary_start = in.number<std::uint64_t>();
  footer.summary_offset_start = in.number<std::uint64_t>();
  footer.summary_crc = in.number<std::uint32_t>();
  return footer;
}

ChunkHead read_chunk_head(Span& contents) {
  ByteReader in(contents);
  ChunkHead head;
  head.start_ns = in.number<std::uint64_t>();
  head.end_ns = in.number<std::uint64_t>();
  head.size = in.number<std::uint64_t>();
  head.crc = in.number<std::uint32_t>();
  head.compression = in.text();
  contents = in.sized<std::uint64_t>();
  return head;
}

}  // namespace tacit::mcap
