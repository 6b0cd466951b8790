#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "idl/types/event.h"

namespace tacit {

/// The event that a line of an event log tells; the inverse of `to_line`, bit for bit: `to_line` of
/// what is returned is `line`. None for every text that `to_line` does not write, such as an event
/// that nobody knows, a key that is missing, too much or elsewhere, a number in another spelling or
/// one that is not finite.
[[nodiscard]] std::optional<Event> event_in(std::string_view line);

/// Gives every event of an event log to `take`, in order. A last line without its newline is what a
/// killed process was writing, and is passed over. Throws RecordError, which names the line, when
/// `file` cannot be read or holds a line that is no event.
void read_events(const std::filesystem::path& file, const std::function<void(const Event&)>& take);

}  // namespace tacit
