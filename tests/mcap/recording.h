#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "console/mcap/reader.h"
#include "console/mcap/writer.h"

namespace tacit::test {

/// A file name that nobody has used, gone when this goes.
class ScratchFile {
 public:
  ScratchFile()
      : path_(std::filesystem::temp_directory_path() /
              ("tacit_mcap_" + std::to_string(::getpid()) + '_' + std::to_string(++calls()))) {}
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  static int& calls() {
    static int calls = 0;
    return calls;
  }
  std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void write_text(const std::filesystem::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary)
      .write(text.data(), static_cast<std::streamsize>(text.size()));
}

/// A message as the tests compare it.
struct Heard {
  std::uint16_t channel = 0;
  std::uint64_t time_ns = 0;
  std::string data;
  friend bool operator==(const Heard&, const Heard&) = default;
};

inline std::vector<Heard> heard(const McapReader& reader, McapReader::Stretch stretch = {}) {
  std::vector<Heard> all;
  reader.read(stretch, [&](const mcap::Message& message) {
    all.push_back({message.channel, message.log_time_ns,
                   std::string(message.data.begin(), message.data.end())});
  });
  return all;
}

inline mcap::Span span_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// 200 messages on two channels in chunks of about ten, an attachment and metadata.
class Sample {
 public:
  Sample() : writer_(file_.path(), small_chunks()) {
    const std::uint16_t schema = writer_.add_schema("pkg/msg/Type", "ros2msg", "uint8 x\n");
    one_ = writer_.add_channel(schema, "/one", "cdr");
    two_ = writer_.add_channel(0, "/two", "json");
    writer_.note({"run", {{"seed", "7"}, {"scenario", "guard"}}});
    for (std::uint64_t i = 0; i < 200; ++i) say(i % 3 == 0 ? two_ : one_, 1000 * i);
    writer_.attach({5, 6, "scenario.toml", "application/toml", "[run]\nseed = 7\n"});
  }
  void say(std::uint16_t channel, std::uint64_t time_ns) {
    const std::string data = "message " + std::to_string(said_.size()) + std::string(80, '.');
    writer_.write(channel, time_ns, span_of(data));
    said_.push_back({channel, time_ns, data});
  }
  McapWriter& writer() { return writer_; }
  [[nodiscard]] const std::filesystem::path& path() const { return file_.path(); }
  [[nodiscard]] const std::vector<Heard>& said() const { return said_; }
  [[nodiscard]] std::uint16_t one() const { return one_; }
  [[nodiscard]] std::uint16_t two() const { return two_; }

 private:
  static McapWriter::Setting small_chunks() {
    McapWriter::Setting setting;
    setting.chunk_bytes = 1200;
    return setting;
  }

  ScratchFile file_;
  McapWriter writer_;
  std::uint16_t one_ = 0;
  std::uint16_t two_ = 0;
  std::vector<Heard> said_;
};

}  // namespace tacit::test
