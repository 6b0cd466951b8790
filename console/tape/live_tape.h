#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "console/record/run_directory.h"
#include "console/tape/tape.h"

namespace tacit {

/// The tape of a run that goes on also when its tape cannot: that is told once, and then there is
/// no tape. What a process that died in this run had recorded there is kept beside it.
class LiveTape {
 public:
  /// Tells people one line.
  using Say = std::function<void(const std::string&)>;

  /// Off.
  LiveTape() = default;
  /// Throws McapError when `file` cannot be made.
  LiveTape(const std::filesystem::path& file, const RunDirectory& directory, Say say);

  template <class Word>
  void add(const Word& word, Tape::Bytes bytes) {
    guarded([&](Tape& tape) { tape.add(word, bytes); });
  }
  void keep() {
    guarded([](Tape& tape) { tape.keep(); });
  }
  /// Closes the file; that of a complete run then outlasts the machine's power.
  void finish(const RunOutcome& outcome);

 private:
  void guarded(const std::function<void(Tape&)>& act);

  Say say_;
  std::optional<Tape> tape_;
};

}  // namespace tacit
