// How long a map of some 50 MB takes to be read, beside copying its text.

#include <benchmark/benchmark.h>

#include <cstring>
#include <string>
#include <vector>

#include "idl/overlay/office.h"
#include "idl/overlay/reader.h"
#include "idl/overlay/writer.h"

namespace tacit {
namespace {

/// Office buildings one behind another.
const std::string& large_map() {
  static const std::string text = [] {
    constexpr std::size_t kSize = 50'000'000;
    std::string all;
    for (std::uint64_t seed = 0; all.size() < kSize; ++seed) {
      all += to_text(random_office(seed, {}));
    }
    return all;
  }();
  return text;
}

void count_bytes(benchmark::State& state) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(large_map().size()));
}

void CopyMap(benchmark::State& state) {
  const std::string& text = large_map();
  std::vector<char> copy(text.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), text.data(), text.size());
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  count_bytes(state);
}
BENCHMARK(CopyMap)->Unit(benchmark::kMillisecond);

void ReadMap(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_overlay(large_map()));
  }
  count_bytes(state);
}
BENCHMARK(ReadMap)->Unit(benchmark::kMillisecond);

/// By the share of the map that is read.
void ReadPartOfMap(benchmark::State& state) {
  const std::string_view part =
      std::string_view(large_map()).substr(0, static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_overlay(part));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * state.range(0));
}
BENCHMARK(ReadPartOfMap)
    ->Unit(benchmark::kMillisecond)
    ->RangeMultiplier(4)
    ->Range(1 << 18, 1 << 24);

void PrintMap(benchmark::State& state) {
  const OverlayMap map = read_overlay(large_map()).map;
  for (auto _ : state) {
    benchmark::DoNotOptimize(to_text(map));
  }
  count_bytes(state);
}
BENCHMARK(PrintMap)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tacit
