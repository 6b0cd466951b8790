#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/architecture/rules.h"

namespace tacit {
namespace {

std::string listed(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) {
    text += '\n' + finding;
  }
  return text;
}

std::vector<SourceFile> pure_sources() {
  return sources(TACIT_SOURCE_DIR,
                 {"idl/types", "idl/cdl", "idl/overlay", "robot_agent/brain", "world_server/world",
                  "console/metrics", "console/debrief", "console/report", "wizard_service/cbr"});
}

std::vector<SourceFile> all_sources() {
  return sources(TACIT_SOURCE_DIR, {"idl", "robot_agent", "world_server", "console",
                                    "wizard_service", "deploy", "tests"});
}

LinkGraph link_graph() {
  std::ifstream in(TACIT_LINK_GRAPH);
  return parse_link_graph({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
}

TEST(Tree, KeepsPureFoldersPure) {
  const std::vector<SourceFile> files = pure_sources();
  ASSERT_GT(files.size(), 20U);
  const Findings findings = impurities(files);
  EXPECT_TRUE(findings.empty()) << listed(findings);
}

TEST(Tree, KeepsMiddlewareInItsPlace) {
  const Findings findings = misplaced_middleware(all_sources());
  EXPECT_TRUE(findings.empty()) << listed(findings);
}

TEST(Tree, WritesIncludesFromTheRoot) {
  const Findings findings = relative_includes(all_sources());
  EXPECT_TRUE(findings.empty()) << listed(findings);
}

TEST(Tree, LinksWhatTheTableAllows) {
  const LinkGraph graph = link_graph();
  ASSERT_TRUE(graph.contains("brain"));
  const Findings findings = forbidden_links(graph);
  EXPECT_TRUE(findings.empty()) << listed(findings);
}

/// Whether pure code that holds `line` is found out.
bool is_impure(const std::string& line) { return !impurities({{"pure.cpp", line}}).empty(); }

class ImpureLine : public testing::TestWithParam<const char*> {};

TEST_P(ImpureLine, IsFound) { EXPECT_TRUE(is_impure(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Sample, ImpureLine,
                         testing::Values("#include <thread>", "#include <fstream>",
                                         "#include <fastdds/dds/topic/Topic.hpp>",
                                         "double x = std::sin(1.0);", "double x = cos(1.0);",
                                         "int x = rand();", "std::mt19937_64 engine;",
                                         "std::normal_distribution<double> d;",
                                         "auto now = std::chrono::steady_clock::now();",
                                         "std::unordered_map<int, int> m;",
                                         "std::set<const Robot*> robots;", "std::mutex mutex;",
                                         "  time(nullptr);", "printf(\"x\");",
                                         "/* a */ double y = std::pow(x, 2);"));

class PureLine : public testing::TestWithParam<const char*> {};

TEST_P(PureLine, IsLeftAlone) { EXPECT_FALSE(is_impure(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Sample, PureLine,
                         testing::Values("#include <vector>", "double x = std::sqrt(2.0);",
                                         "// as std::sin would", "auto s = \"std::sin(\";",
                                         "double y = heading.cos * x;", "void log_collision();",
                                         "const long n = 1'000'000;", "x.time();",
                                         "std::map<int, Robot*> robots;"));

TEST(Middleware, IsFoundOutsideItsPlace) {
  EXPECT_EQ(misplaced_middleware({{"world_server/world/world.cpp", "#include <btBulletCommon.h>"}})
                .size(),
            1U);
  EXPECT_EQ(misplaced_middleware({{"robot_agent/app/main.cpp", "#include <fastdds/x.hpp>"}}).size(),
            1U);
  EXPECT_EQ(misplaced_middleware({{"deploy/tacit/main.cpp", "#include <toml++/toml.h>"}}).size(),
            1U);
  EXPECT_EQ(misplaced_middleware({{"idl/scenario/x.cpp", "#include <tao/pegtl.hpp>"}}).size(), 1U);
  EXPECT_EQ(misplaced_middleware({{"console/app/main.cpp", "#include <zstd.h>"}}).size(), 1U);
  EXPECT_EQ(misplaced_middleware({{"console/record/x.h", "#include <boost/crc.hpp>"}}).size(), 1U);
  EXPECT_EQ(misplaced_middleware({{"console/app/x.cpp", "#include <boost/asio/post.hpp>"}}).size(),
            1U);
  EXPECT_EQ(misplaced_middleware({{"console/app/x.cpp", "#include <boost/beast.hpp>"}}).size(), 1U);
}

TEST(Middleware, IsLeftAloneInItsPlace) {
  EXPECT_TRUE(misplaced_middleware({{"world_server/world/physics.cpp", "#include <btBullet.h>"},
                                    {"idl/bus/qos.cpp", "#include <fastdds/x.hpp>"}})
                  .empty());
}

TEST(RelativeInclude, IsFound) {
  EXPECT_EQ(relative_includes({{"a/b.cpp", "#include \"../c.h\""}}).size(), 1U);
  EXPECT_EQ(relative_includes({{"a/b.cpp", "#include \"c.h\""}}).size(), 1U);
}

TEST(LinkTable, FindsALinkThatItDoesNotHave) {
  EXPECT_EQ(forbidden_links(parse_link_graph("brain: types world\n")),
            Findings{"brain: may not use world"});
}

TEST(LinkTable, FindsALibraryThatItDoesNotKnow) {
  EXPECT_EQ(forbidden_links(parse_link_graph("common: types\n")),
            Findings{"common: not in the table of who may use whom"});
}

}  // namespace
}  // namespace tacit
