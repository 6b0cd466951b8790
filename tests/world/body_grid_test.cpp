#include "world_server/world/sensing/body_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "idl/types/random.h"

namespace tacit {
namespace {

constexpr double kWidth_m = 120.0;
constexpr double kHeight_m = 60.0;

std::vector<WorldVec> scattered(std::size_t count, Stream& chance) {
  std::vector<WorldVec> places;
  for (std::size_t i = 0; i < count; ++i) {
    // A tenth stands outside, as happens when the area has no border.
    places.emplace_back(chance.uniform(-0.05 * kWidth_m, 1.05 * kWidth_m),
                        chance.uniform(-0.05 * kHeight_m, 1.05 * kHeight_m));
  }
  return places;
}

std::vector<std::size_t> near(const BodyGrid& grid, const WorldVec& p, double range_m) {
  std::vector<std::size_t> found;
  grid.near(p, range_m,
            [&found](std::size_t body, const WorldVec& /*place*/) { found.push_back(body); });
  return found;
}

TEST(BodyGrid, MissesNobodyInRangeAndNamesNobodyTwice) {
  Stream chance(1, "grid");
  BodyGrid grid(kWidth_m, kHeight_m, 10.0);
  for (const std::size_t count : {1u, 2u, 10u, 300u}) {
    const std::vector<WorldVec> places = scattered(count, chance);
    grid.rebuild(places);
    for (const WorldVec& p : places) {
      const double range = chance.uniform(0.1, 40.0);
      std::vector<std::size_t> found = near(grid, p, range);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE((places[i] - p).norm() > range ||
                    std::binary_search(found.begin(), found.end(), i));
      }
    }
  }
}

TEST(BodyGrid, TellsEachBodysPlace) {
  Stream chance(4, "grid");
  BodyGrid grid(kWidth_m, kHeight_m, 10.0);
  const std::vector<WorldVec> places = scattered(100, chance);
  grid.rebuild(places);
  std::size_t visited = 0;
  grid.near({60.0, 30.0}, 200.0, [&](std::size_t body, const WorldVec& place) {
    EXPECT_EQ(place, places[body]);
    ++visited;
  });
  EXPECT_EQ(visited, places.size());
}

TEST(BodyGrid, NamesOnlyAFewOfManyWhenTheRangeIsShort) {
  Stream chance(2, "grid");
  BodyGrid grid(kWidth_m, kHeight_m, 2.0);
  const std::vector<WorldVec> places = scattered(2000, chance);
  grid.rebuild(places);
  EXPECT_LT(near(grid, {60.0, 30.0}, 2.0).size(), 100u);
}

TEST(BodyGrid, NamesTheSameBodiesInTheSameOrderEveryTime) {
  Stream chance(3, "grid");
  const std::vector<WorldVec> places = scattered(200, chance);
  BodyGrid used(kWidth_m, kHeight_m, 10.0);
  used.rebuild(scattered(500, chance));
  used.rebuild(places);
  BodyGrid fresh(kWidth_m, kHeight_m, 10.0);
  fresh.rebuild(places);
  EXPECT_EQ(near(used, {50.0, 20.0}, 25.0), near(fresh, {50.0, 20.0}, 25.0));
}

TEST(BodyGrid, IsEmptyWithoutBodies) {
  BodyGrid grid(kWidth_m, kHeight_m, 10.0);
  grid.rebuild({});
  EXPECT_TRUE(near(grid, {50.0, 20.0}, 1000.0).empty());
}

}  // namespace
}  // namespace tacit
