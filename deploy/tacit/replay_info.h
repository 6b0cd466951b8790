#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "console/tape/tape_reader.h"

namespace tacit {

/// What a recording holds.
struct ReplayInfo {
  std::string trouble;                            ///< Why the file is not whole; empty when it is.
  std::map<std::string, std::uint64_t> messages;  ///< Of each channel.
  std::map<std::string, std::uint64_t> attachments;  ///< Bytes of each.
  std::map<std::string, std::map<std::string, std::string>> metadata;
  double begin_s = 0.0;  ///< Simulated.
  double end_s = 0.0;
  std::uint64_t events = 0;
  std::string event_log_sha256;  ///< Of the events that are in it, as an event log.
};

/// Goes through all of it. Throws McapError.
[[nodiscard]] ReplayInfo info_of(const TapeReader& tape);

/// For people; ends with a newline.
[[nodiscard]] std::string info_text(const ReplayInfo& info);
/// One JSON object without a newline.
[[nodiscard]] std::string info_json(const ReplayInfo& info);

}  // namespace tacit
