#include "console/tape/live_tape.h"

#include <utility>

#include "console/record/files.h"

namespace tacit {

LiveTape::LiveTape(const std::filesystem::path& file, const RunDirectory& directory, Say say)
    : say_(std::move(say)) {
  std::error_code error;
  if (std::filesystem::exists(file)) std::filesystem::rename(file, spare_name(file), error);
  tape_.emplace(file, directory.facts(), read_whole_file(directory.scenario_file()));
}

void LiveTape::finish(const RunOutcome& outcome) {
  guarded([&](Tape& tape) {
    tape.finish(outcome);
    if (outcome.complete) sync_file(tape.file());
  });
  tape_.reset();
}

void LiveTape::guarded(const std::function<void(Tape&)>& act) {
  if (!tape_) return;
  try {
    act(*tape_);
  } catch (const std::exception& error) {
    say_("the recording ends here, the run goes on: " + std::string(error.what()));
    tape_.reset();
  }
}

}  // namespace tacit
