#include <gtest/gtest.h>

#include <chrono>

#include "idl/cdl/check.h"
#include "idl/cdl/diagram.h"
#include "idl/cdl/parse.h"
#include "idl/cdl/print.h"
#include "idl/cdl/resolve.h"
#include "idl/types/random.h"
#include "tests/cdl/laws.h"
#include "tests/cdl/samples.h"

namespace tacit::cdl {
namespace {

void mutate(std::string& text, Stream& chance) {
  static const std::string kSigns = "[](){}<>|,;:=%^\"/*\n$A0";
  const std::size_t at = chance.below(text.size() + 1);
  switch (chance.below(4)) {
    case 0:
      text.insert(at, 1, kSigns[chance.below(kSigns.size())]);
      break;
    case 1:
      text.erase(at, chance.below(20));
      break;
    case 2:
      text.insert(at, text.substr(chance.below(text.size() + 1), chance.below(60)));
      break;
    default:
      if (at < text.size()) {
        text[at] = static_cast<char>(chance.below(256));
      }
  }
}

void use(const std::string& text) {
  EXPECT_EQ(broken_law(text), "") << text;
  const Parsed parsed = parse(text);
  (void)print(parsed.mission, text);
  (void)check(parsed.mission, text);
  (void)to_scxml(diagram_of(resolve(parsed.mission).robots));
}

TEST(Mutations, KeepTheLawsAndNeitherCrashNorTakeLong) {
  Stream chance(11, "mutations");
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 4000; ++i) {
    std::string text = own_sample(i % 2 == 0 ? "patrol.cdl" : "learner.cdl");
    for (std::uint64_t n = chance.below(6); n <= 6; ++n) {
      mutate(text, chance);
    }
    use(text);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(40));
}

TEST(Hostile, TextsTakeTimeInProportion) {
  for (const char* part : {"/*", "|", "{", "\"", "<1,", "[", "a:", "rules[", "if ", "%", "/*\n",
                           "{\"", "instBP ", "defOp ", "a,", "(", "]", "\xFF"}) {
    std::string text;
    while (text.size() < 1'000'000) {
      text += part;
    }
    const auto begin = std::chrono::steady_clock::now();
    (void)check_text(text);
    (void)check_text(text + '\0');
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << part;
  }
}

}  // namespace
}  // namespace tacit::cdl
