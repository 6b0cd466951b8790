// How long it takes to find the five best cases, in the tree and by looking at every case, in the
// same run; and how long the slowest queries take. Each query leaves features open, with a chance
// of one in four.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <vector>

#include "tests/cbr/libraries.h"
#include "wizard_service/cbr/case_index.h"

namespace tacit::cbr {
namespace {

constexpr std::size_t kTop = 5;
constexpr std::size_t kQueries = 10'000;

const std::vector<CaseHead>& library(std::int64_t size) {
  static std::map<std::int64_t, std::vector<CaseHead>> made;
  std::vector<CaseHead>& one = made[size];
  if (one.empty()) one = random_library(1, static_cast<std::size_t>(size));
  return one;
}

const std::vector<Query>& queries() {
  static const std::vector<Query> all = [] {
    Stream chance(1, "queries");
    std::vector<Query> drawn(kQueries);
    for (Query& query : drawn) query = random_query(chance, 4);
    return drawn;
  }();
  return all;
}

void RetrieveByTree(benchmark::State& state) {
  const CaseIndex index(library(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(index.retrieve(queries()[i++ % kQueries], kTop));
  }
}
BENCHMARK(RetrieveByTree)->RangeMultiplier(10)->Range(1'000, 1'000'000);

void RetrieveByScan(benchmark::State& state) {
  const std::vector<CaseHead>& cases = library(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(retrieve_by_scan(cases, queries()[i++ % kQueries], kTop));
  }
}
BENCHMARK(RetrieveByScan)->RangeMultiplier(10)->Range(1'000, 1'000'000);

/// 10,000 queries one by one; what share of them takes no longer.
void SlowestQueries(benchmark::State& state) {
  const CaseIndex index(library(state.range(0)));
  std::vector<double> took_us;
  for (auto _ : state) {
    took_us.clear();
    for (const Query& query : queries()) {
      const auto begin = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(index.retrieve(query, kTop));
      const std::chrono::duration<double, std::micro> took =
          std::chrono::steady_clock::now() - begin;
      took_us.push_back(took.count());
    }
  }
  std::sort(took_us.begin(), took_us.end());
  state.counters["p50_us"] = took_us[kQueries / 2];
  state.counters["p99_us"] = took_us[kQueries * 99 / 100];
  state.counters["most_us"] = took_us.back();
}
BENCHMARK(SlowestQueries)->Arg(100'000)->Unit(benchmark::kMillisecond);

void BuildTree(benchmark::State& state) {
  const std::vector<CaseHead>& cases = library(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(CaseIndex(cases));
  }
}
BENCHMARK(BuildTree)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void UpdateCase(benchmark::State& state) {
  std::vector<CaseHead> cases = library(state.range(0));
  CaseIndex index(cases);
  Stream chance(2, "updates");
  for (auto _ : state) {
    CaseHead& head = cases[chance.below(cases.size())];
    head.standing = static_cast<int>(chance.below(2001)) - 1000;
    index.update(head);
  }
}
BENCHMARK(UpdateCase)->RangeMultiplier(10)->Range(1'000, 1'000'000);

}  // namespace
}  // namespace tacit::cbr
