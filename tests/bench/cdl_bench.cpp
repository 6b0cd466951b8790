#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <limits>
#include <string>

#include "idl/cdl/check.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"
#include "tests/cdl/large_mission.h"

namespace tacit::cdl {
namespace {

/// Of this thread's own work, so that others on the machine do not count. [s]
double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

const std::string& mission_text() {
  static const std::string text = large_mission(50'000'000);
  return text;
}

void count_bytes(benchmark::State& state) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(mission_text().size()));
}

double best_copy_s() {
  const std::string& text = mission_text();
  std::string copy(text.size(), '\0');
  double best = 1e9;
  for (int i = 0; i < 10; ++i) {
    const double begin = cpu_s();
    std::memcpy(copy.data(), text.data(), text.size());
    benchmark::DoNotOptimize(copy.data());
    best = std::min(best, cpu_s() - begin);
  }
  return best;
}

void Copy(benchmark::State& state) {
  const std::string& text = mission_text();
  std::string copy(text.size(), '\0');
  for (auto _ : state) {
    std::memcpy(copy.data(), text.data(), text.size());
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  count_bytes(state);
}
BENCHMARK(Copy)->Unit(benchmark::kMillisecond);

/// Beside a copy of the same bytes in the same run, which says what the machine can do.
void parse_and_compare(benchmark::State& state, void (*prepare)()) {
  double best = std::numeric_limits<double>::max();
  for (auto _ : state) {
    prepare();
    const double begin = cpu_s();
    const Parsed parsed = parse(mission_text());
    const double taken = cpu_s() - begin;
    state.SetIterationTime(taken);
    best = std::min(best, taken);
    benchmark::DoNotOptimize(&parsed);
  }
  count_bytes(state);
  state.counters["times_memcpy"] = best / best_copy_s();
}

void Parse(benchmark::State& state) {
  (void)parse(mission_text());
  parse_and_compare(state, [] {});
}
BENCHMARK(Parse)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(10);

/// The system hands out every page anew, as to a program that reads one file and ends.
void ParseIntoNewMemory(benchmark::State& state) {
  parse_and_compare(state, [] { malloc_trim(0); });
}
BENCHMARK(ParseIntoNewMemory)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(3);

void Print(benchmark::State& state) {
  const Mission mission = parse(mission_text()).mission;
  for (auto _ : state) {
    benchmark::DoNotOptimize(print(mission));
  }
  count_bytes(state);
}
BENCHMARK(Print)->Unit(benchmark::kMillisecond)->Iterations(5);

void CheckText(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(check_text(mission_text()));
  }
  count_bytes(state);
}
BENCHMARK(CheckText)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace tacit::cdl

int main(int argc, char** argv) {
  // What was freed stays with the program, so that Parse measures parsing and not the system.
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_MMAP_MAX, 0);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
