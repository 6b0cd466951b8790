#include "console/record/run.h"

#include <array>
#include <ctime>

namespace tacit {

std::optional<double> RunOutcome::metric(std::string_view key) const {
  for (const RecordedMetric& metric : metrics) {
    if (metric.key == key && metric.value) {
      return std::visit([](auto number) { return static_cast<double>(number); }, *metric.value);
    }
  }
  return std::nullopt;
}

std::vector<RecordedMetric> recorded(const Tally& tally) {
  std::vector<RecordedMetric> all;
  for (const Metric& metric : tally.metrics()) {
    all.push_back({std::string(metric.key), metric.value});
  }
  return all;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, sizeof "2030-01-31T23:59:59Z"> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

}  // namespace tacit
