#include "console/mcap/reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <queue>
#include <system_error>
#include <tuple>
#include <utility>

#include "console/mcap/compression.h"
#include "console/mcap/crc32.h"

namespace tacit {

using namespace mcap;

namespace {

std::string system_reason() { return std::generic_category().message(errno); }

/// Calls `take(op, contents, offset)` for each record in `bytes`. Throws TooShort.
template <class Take>
void each_record(Span bytes, Take&& take) {
  for (ByteReader in(bytes); !in.done();) {
    const std::size_t offset = bytes.size() - in.rest().size();
    const auto op = static_cast<Op>(in.number<std::uint8_t>());
    take(op, in.sized<std::uint64_t>(), offset);
  }
}

/// What chunks that overlap in time may hold together. [ours]
constexpr std::uint64_t kMostOpenBytes = 2 * kMostChunkBytes;

std::string at_byte(std::uint64_t offset) { return "at byte " + std::to_string(offset); }

}  // namespace

McapReader::McapReader(std::filesystem::path file) : file_(std::move(file)) {
  fd_ = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat facts {};
  if (fd_ < 0 || ::fstat(fd_, &facts) != 0) throw McapError(file_, system_reason());
  try {
    if (!S_ISREG(facts.st_mode)) throw McapError(file_, "is no file");
    size_ = static_cast<std::uint64_t>(facts.st_size);
    const Bytes magic = bytes_at(0, std::min<std::uint64_t>(size_, kMagic.size()));
    if (!std::equal(magic.begin(), magic.end(), kMagic.begin(), kMagic.end())) {
      throw McapError(file_, "is no MCAP file");
    }
    try {
      read_summary();
    } catch (const std::exception& error) {
      forget();
      trouble_ = error.what();
      scan();
    }
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

McapReader::~McapReader() { ::close(fd_); }

Bytes McapReader::bytes_at(std::uint64_t offset, std::uint64_t length) const {
  if (offset > size_ || length > size_ - offset) throw TooShort();
  Bytes bytes(static_cast<std::size_t>(length));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t got =
        ::pread(fd_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got == 0) throw TooShort();
    if (got < 0 && errno != EINTR) throw McapError(file_, "cannot be read: " + system_reason());
    done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
  }
  return bytes;
}

McapReader::Record McapReader::record_at(std::uint64_t offset) const {
  const Bytes head = bytes_at(offset, kRecordHead);
  ByteReader in(head);
  Record record{static_cast<Op>(in.number<std::uint8_t>()), {}, offset, 0};
  const auto length = in.number<std::uint64_t>();
  record.contents = bytes_at(offset + kRecordHead, length);
  record.end = offset + kRecordHead + length;
  return record;
}

/// Throws what it likes when there is none, or none that is sound.
void McapReader::read_summary() {
  if (size_ < 2 * kMagic.size() + kFooterSize) throw std::runtime_error("it has no end");
  const Bytes end = bytes_at(size_ - kMagic.size(), kMagic.size());
  if (!std::equal(end.begin(), end.end(), kMagic.begin())) {
    throw std::runtime_error("it has no end: its writer was cut off");
  }
  const std::uint64_t footer_at = size_ - kMagic.size() - kFooterSize;
  const Record last = record_at(footer_at);
  if (last.op != Op::Footer) throw std::runtime_error("it has no footer");
  const Footer footer = read_footer(last.contents);
  if (footer.summary_start == 0) throw std::runtime_error("it has no summary");
  if (footer.summary_start > footer_at) throw std::runtime_error("its summary is nowhere");
  const Bytes summary = bytes_at(
      footer.summary_start, footer_at + kFooterSize - sizeof(std::uint32_t) - footer.summary_start);
  if (footer.summary_crc != 0 && footer.summary_crc != crc32(summary)) {
    throw std::runtime_error("the checksum of its summary is wrong");
  }
  data_end_ = footer.summary_start;
  for (std::uint64_t at = footer.summary_start; at < footer_at;) {
    const Record record = record_at(at);
    take_summary(record);
    at = record.end;
  }
  if (statistics_.messages > 0 && places_.empty()) {
    throw std::runtime_error("its summary has no index");
  }
}

void McapReader::take_summary(const Record& record) {
  switch (record.op) {
    case Op::Schema: {
      Schema schema = read_schema(record.contents);
      schemas_[schema.id] = std::move(schema);
      break;
    }
    case Op::Channel: {
      Channel channel = read_channel(record.contents);
      channels_[channel.id] = std::move(channel);
      break;
    }
    case Op::Statistics:
      statistics_ = read_statistics(record.contents);
      break;
    case Op::ChunkIndex: {
      const ChunkIndex index = read_chunk_index(record.contents);
      places_.push_back({index.offset, index.length, index.start_ns, index.end_ns});
      break;
    }
    case Op::AttachmentIndex:
      attachments_.push_back(read_attachment_index(record.contents));
      break;
    case Op::MetadataIndex:
      metadata_.push_back(read_metadata_index(record.contents));
      break;
    default:
      break;
  }
}

void McapReader::forget() {
  schemas_.clear();
  channels_.clear();
  statistics_ = {};
  places_.clear();
  attachments_.clear();
  metadata_.clear();
}

/// Up to the end of what makes sense.
void McapReader::scan() {
  std::uint64_t at = kMagic.size();
  try {
    while (at < size_) {
      const Record record = record_at(at);
      if (record.op == Op::DataEnd || record.op == Op::Footer) break;
      take_data(record);
      at = record.end;
    }
  } catch (const McapError&) {
    throw;
  } catch (const std::exception& error) {
    trouble_ += "; " + at_byte(at) + ": " + error.what();
  }
  statistics_.schemas = static_cast<std::uint16_t>(schemas_.size());
  statistics_.channels = static_cast<std::uint32_t>(channels_.size());
  statistics_.attachments = static_cast<std::uint32_t>(attachments_.size());
  statistics_.metadata = static_cast<std::uint32_t>(metadata_.size());
  statistics_.chunks = static_cast<std::uint32_t>(places_.size());
}

void McapReader::take_data(const Record& record) {
  const std::uint64_t length = record.end - record.offset;
  switch (record.op) {
    case Op::Chunk:
    case Op::Message:
      take_contents({record.offset, length, 0, 0});
      break;
    case Op::Attachment: {
      const Attachment found = read_attachment(record.contents);
      attachments_.push_back({record.offset, length, found.log_time_ns, found.create_time_ns,
                              found.data.size(), found.name, found.media_type});
      break;
    }
    case Op::Metadata:
      metadata_.push_back({record.offset, length, read_metadata(record.contents).name});
      break;
    default:
      take_summary(record);
      break;
  }
}

/// A chunk that is damaged is told of and passed over.
void McapReader::take_contents(const Place& place) {
  Statistics inside;
  try {
    const Bytes contents = contents_of(place);
    each_record(contents, [&](Op op, Span record, std::size_t) {
      if (op == Op::Message) inside.add(read_message(record));
      if (op == Op::Schema || op == Op::Channel) {
        take_summary({op, {record.begin(), record.end()}, 0, 0});
      }
    });
  } catch (const std::exception& error) {
    trouble_ += "; " + std::string(error.what());
    return;
  }
  places_.push_back({place.offset, place.length, inside.start_ns, inside.end_ns});
  if (inside.messages == 0) return;
  statistics_.start_ns =
      statistics_.messages == 0 ? inside.start_ns : std::min(statistics_.start_ns, inside.start_ns);
  statistics_.end_ns = std::max(statistics_.end_ns, inside.end_ns);
  statistics_.messages += inside.messages;
  for (const auto& [channel, count] : inside.of_channel) statistics_.of_channel[channel] += count;
}

Bytes McapReader::contents_of(const Place& place) const {
  const Record record = record_at(place.offset);
  if (record.op == Op::Message) return bytes_at(place.offset, record.end - place.offset);
  if (record.op != Op::Chunk) throw std::runtime_error(at_byte(place.offset) + " is no chunk");
  Span packed = record.contents;
  const ChunkHead head = read_chunk_head(packed);
  Bytes contents = decompressed(packed, head.compression, head.size);
  if (head.crc != 0 && head.crc != crc32(contents)) {
    throw std::runtime_error("the checksum of the chunk " + at_byte(place.offset) + " is wrong");
  }
  return contents;
}

std::optional<std::uint16_t> McapReader::channel(std::string_view topic) const {
  for (const auto& [id, channel] : channels_) {
    if (channel.topic == topic) return id;
  }
  return std::nullopt;
}

Attachment McapReader::attachment(const AttachmentIndex& index) const {
  try {
    const Record record = record_at(index.offset);
    if (record.op != Op::Attachment) {
      throw std::runtime_error("there is no attachment " + at_byte(index.offset));
    }
    return read_attachment(record.contents);
  } catch (const McapError&) {
    throw;
  } catch (const std::exception& error) {
    throw McapError(file_, error.what());
  }
}

std::vector<Metadata> McapReader::metadata() const {
  std::vector<Metadata> all;
  try {
    for (const MetadataIndex& index : metadata_) {
      const Record record = record_at(index.offset);
      if (record.op != Op::Metadata) {
        throw std::runtime_error("there is no metadata " + at_byte(index.offset));
      }
      all.push_back(read_metadata(record.contents));
    }
  } catch (const McapError&) {
    throw;
  } catch (const std::exception& error) {
    throw McapError(file_, error.what());
  }
  return all;
}

/// Chunks may overlap in time. They are opened in order of their beginnings, and a message is given
/// away once no chunk begins before it.
class McapReader::Merge {
 public:
  Merge(const McapReader& reader, Stretch stretch) : reader_(reader), stretch_(stretch) {
    for (const Place& place : reader.places_) {
      if (place.start_ns <= stretch.to_ns && place.end_ns >= stretch.from_ns) {
        places_.push_back(place);
      }
    }
    std::stable_sort(places_.begin(), places_.end(),
                     [](const Place& a, const Place& b) { return a.start_ns < b.start_ns; });
  }

  /// Calls `take` for every message.
  template <class Take>
  void run(Take&& take) {
    for (std::size_t next = 0; next < places_.size() || !waiting_.empty();) {
      if (next < places_.size() &&
          (waiting_.empty() || places_[next].start_ns <= waiting_.top().time_ns)) {
        open(places_[next++]);
      } else {
        const Waiting first = waiting_.top();
        waiting_.pop();
        take(read_message(first.record));
      }
    }
  }

 private:
  struct Waiting {
    std::uint64_t time_ns = 0;
    std::uint64_t chunk = 0;   ///< Where it lies in the file.
    std::uint64_t offset = 0;  ///< In the chunk.
    Span record;
    std::shared_ptr<const Bytes> holder;
    friend bool operator>(const Waiting& a, const Waiting& b) {
      return std::tie(a.time_ns, a.chunk, a.offset) > std::tie(b.time_ns, b.chunk, b.offset);
    }
  };

  void open(const Place& place) {
    const auto contents = held(reader_.contents_of(place));
    each_record(*contents, [&](Op op, Span record, std::size_t offset) {
      if (op != Op::Message) return;
      const std::uint64_t time = read_message(record).log_time_ns;
      if (time < stretch_.from_ns || time > stretch_.to_ns) return;
      waiting_.push({time, place.offset, offset, record, contents});
    });
  }

  /// Counted while anybody waits in it.
  std::shared_ptr<const Bytes> held(Bytes contents) {
    const std::uint64_t size = contents.size();
    if (held_ + size > kMostOpenBytes) throw std::runtime_error("too many chunks are of one time");
    held_ += size;
    return {new Bytes(std::move(contents)), [this, size](const Bytes* bytes) {
              held_ -= size;
              delete bytes;
            }};
  }

  const McapReader& reader_;
  Stretch stretch_;
  std::vector<Place> places_;
  std::uint64_t held_ = 0;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

void McapReader::read(Stretch stretch, const std::function<void(const Message&)>& take) const {
  // What `take` throws is not about the file.
  std::exception_ptr of_taker;
  try {
    Merge(*this, stretch).run([&](const Message& message) {
      try {
        take(message);
      } catch (...) {
        of_taker = std::current_exception();
        throw;
      }
    });
  } catch (const McapError&) {
    throw;
  } catch (const std::exception& error) {
    if (of_taker) std::rethrow_exception(of_taker);
    throw McapError(file_, error.what());
  }
}

bool McapReader::data_checksum_holds() const {
  if (data_end_ == 0) return true;
  constexpr std::uint64_t kDataEndSize = kRecordHead + sizeof(std::uint32_t);
  constexpr std::uint64_t kBlock = std::uint64_t{1} << 20;
  try {
    const std::uint64_t end = data_end_ - std::min(data_end_, kDataEndSize);
    const Record last = record_at(end);
    if (last.op != Op::DataEnd) return false;
    const auto wanted = ByteReader(last.contents).number<std::uint32_t>();
    Crc32 crc;
    for (std::uint64_t at = 0; at < end; at += kBlock) {
      crc.add(bytes_at(at, std::min(kBlock, end - at)));
    }
    return wanted == 0 || wanted == crc.value();
  } catch (const TooShort&) {
    return false;
  }
}

}  // namespace tacit
