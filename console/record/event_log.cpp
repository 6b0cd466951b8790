#include "console/record/event_log.h"

#include "console/record/record_error.h"

namespace tacit {

void EventHash::add(std::span<const Event> events) {
  for (const Event& event : events) {
    hash_.add(to_line(event) + '\n');
  }
}

EventLog::EventLog(const std::filesystem::path& file)
    : file_(file), held_(file_.size()), old_(file, std::ios::binary) {}

void EventLog::append(std::span<const Event> events) {
  lines_.clear();
  const std::size_t fresh = confirm(events);
  if (fresh < lines_.size()) {
    file_.append(std::string_view(lines_).substr(fresh));
  }
  hash_.add(lines_);
  events_ += events.size();
}

std::size_t EventLog::confirm(std::span<const Event> events) {
  std::size_t fresh = 0;
  std::string old_line;
  std::uint64_t index = events_;
  for (const Event& event : events) {
    const std::string line = to_line(event);
    lines_.append(line).append(1, '\n');
    if (expects_more()) {
      std::getline(old_, old_line);
      if (old_line != line) {
        throw RecordError(file_.path(), "event " + std::to_string(index) + " is " + old_line +
                                            ", but the run now has " + line);
      }
      confirmed_ += line.size() + 1;
      fresh = lines_.size();
    }
    ++index;
  }
  return fresh;
}

std::string EventLog::sha256() const {
  return expects_more() ? sha256_of_file(file_.path()) : hash_.hex();
}

}  // namespace tacit
