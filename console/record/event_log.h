#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "console/record/append_file.h"
#include "console/record/sha256.h"
#include "idl/types/event.h"

namespace tacit {

/// The SHA-256 that an event log of these events has, without writing it.
class EventHash {
 public:
  void add(std::span<const Event> events);
  [[nodiscard]] std::string hex() const { return hash_.hex(); }

 private:
  Sha256 hash_;
};

/// The event log: one line of JSON per event, in order, never changed once written.
///
/// A log that is opened again expects the run's events from the first on: those it holds already
/// are compared with it, the others appended.
class EventLog {
 public:
  /// Opens or creates `file` as AppendFile does. Throws RecordError.
  explicit EventLog(const std::filesystem::path& file);

  /// Takes the run's next events; one write for all of them. Throws RecordError when they cannot
  /// be written, and when the log holds others in their place; the file then stays as it was.
  void append(std::span<const Event> events);

  /// How many events have been taken since opening.
  [[nodiscard]] std::uint64_t events() const { return events_; }
  /// Whether the log holds events from before it was opened that have not come again.
  [[nodiscard]] bool expects_more() const { return confirmed_ < held_; }
  /// Of the file as it is.
  [[nodiscard]] std::string sha256() const;

 private:
  /// Compares with the log as far as it goes; returns where in `lines_` the new lines begin.
  std::size_t confirm(std::span<const Event> events);

  AppendFile file_;
  std::uint64_t held_;  ///< Bytes that were in the file when it was opened.
  std::uint64_t confirmed_ = 0;
  std::uint64_t events_ = 0;
  std::ifstream old_;
  std::string lines_;
  Sha256 hash_;
};

}  // namespace tacit
