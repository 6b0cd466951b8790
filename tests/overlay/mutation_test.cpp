#include <gtest/gtest.h>

#include "idl/overlay/change_script.h"
#include "idl/overlay/ground.h"
#include "idl/overlay/writer.h"
#include "idl/types/random.h"
#include "tests/overlay/sample_map.h"

namespace tacit {
namespace {

std::string mutated(std::string text, Stream& chance) {
  for (std::uint64_t n = 1 + chance.below(4); n > 0 && !text.empty(); --n) {
    const std::size_t at = chance.below(text.size());
    switch (chance.below(3)) {
      case 0:
        text[at] = static_cast<char>(chance.below(256));
        break;
      case 1:
        text.erase(at, 1 + chance.below(9));
        break;
      default:
        text.insert(at, text.substr(chance.below(text.size()), chance.below(30)));
    }
  }
  return text;
}

TEST(MutatedMap, IsReadCheckedAndPrintedBackByteForByte) {
  Stream chance(11, "mutations");
  for (int round = 0; round < 3000; ++round) {
    const std::string text = mutated(kSampleMap, chance);
    const OverlayReading reading = read_overlay(text);
    ASSERT_EQ(to_text(reading.map), text);
    ASSERT_LE(check(reading.map).size(), kMostFindings);
    (void)ground_of(reading.map, Doors::Open);
    (void)read_changes(text);
  }
}

TEST(TruncatedMap, PrintsBackByteForByteWhereverItEnds) {
  for (std::size_t size = 0; size <= kSampleMap.size(); ++size) {
    const std::string text = kSampleMap.substr(0, size);
    ASSERT_EQ(to_text(map_of(text)), text);
  }
}

}  // namespace
}  // namespace tacit
