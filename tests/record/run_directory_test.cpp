#include "console/record/run_directory.h"

#include "console/record/json.h"
#include "console/record/record_error.h"
#include "idl/types/config_error.h"
#include "tests/record/full_disk.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

RunFacts some_facts() {
  RunFacts facts;
  facts.version = "0.1.0";
  facts.scenario = "guard \"night\"";
  facts.seed = 9'007'199'254'740'993;  // More than a double holds.
  facts.transport = "dds";
  facts.robots = 6;
  facts.learner = "lm";
  facts.strategy = 4;
  facts.command_line = {"tacit", "run", "guard"};
  facts.started = "2030-01-31T23:59:59Z";
  return facts;
}

RunOutcome an_outcome() {
  RunOutcome outcome;
  outcome.complete = true;
  outcome.repeatable = true;
  outcome.ticks = 9000;
  outcome.events = 321;
  outcome.wall_s = 4.5;
  outcome.event_log_sha256 = "ab12";
  outcome.metrics = {{"created", std::uint64_t{7}}, {"mean_m", 0.1 + 0.2}, {"idle_m", {}}};
  return outcome;
}

class RunDirectoryTest : public ScratchTest {
 protected:
  const std::filesystem::path run = folder / "a" / "run";
  std::string create_complaint() const {
    return complaint<ConfigError>([&] { (void)RunDirectory::create(run, some_facts(), "x"); });
  }
  std::string open_complaint() const {
    return complaint<ConfigError>([&] { (void)RunDirectory::open(run); });
  }
};

TEST_F(RunDirectoryTest, KeepsScenarioAndFacts) {
  const auto made = RunDirectory::create(run, some_facts(), "seed = 1\n");
  const auto read = RunDirectory::open(run);

  EXPECT_EQ(read.facts(), made.facts());
  EXPECT_EQ(read.facts().seed, some_facts().seed);
  EXPECT_EQ(text_of(read.scenario_file()), "seed = 1\n");
}

TEST_F(RunDirectoryTest, MakesUpAKeyOfItsOwn) {
  const auto first = RunDirectory::create(folder / "one", some_facts(), "");
  const auto second = RunDirectory::create(folder / "two", some_facts(), "");

  EXPECT_EQ(first.facts().key.size(), 64);
  EXPECT_NE(first.facts().key, second.facts().key);
}

TEST_F(RunDirectoryTest, KeepsAKeyThatIsGiven) {
  RunFacts facts = some_facts();
  facts.key = "battery/17";

  EXPECT_EQ(RunDirectory::create(run, facts, "").facts().key, "battery/17");
}

TEST_F(RunDirectoryTest, RefusesAnOccupiedFolder) {
  std::filesystem::create_directories(run);
  put(run / "thesis.txt", "mine");

  EXPECT_EQ(create_complaint(), run.string() +
                                    ": is occupied (it holds thesis.txt), wanted a new or empty "
                                    "directory");
  EXPECT_FALSE(std::filesystem::exists(run / "run.json"));
}

TEST_F(RunDirectoryTest, RefusesTheDirectoryOfAnotherRun) {
  (void)RunDirectory::create(run, some_facts(), "");

  EXPECT_NE(create_complaint().find("is occupied"), std::string::npos);
}

TEST_F(RunDirectoryTest, AcceptsAFolderThatHoldsLogsOnly) {
  std::filesystem::create_directories(run / "logs");

  EXPECT_EQ(create_complaint(), "(no complaint)");
}

TEST_F(RunDirectoryTest, RefusesAFileInItsPlace) {
  std::filesystem::create_directories(run.parent_path());
  put(run, "");

  EXPECT_NE(create_complaint().find(run.string() + ": "), std::string::npos);
}

TEST_F(RunDirectoryTest, AFullDiskIsSaidBeforeTheRun) {
  const FullDisk full(0);
  EXPECT_NE(create_complaint().find("scenario.toml"), std::string::npos);
}

TEST_F(RunDirectoryTest, HasNoOutcomeBeforeTheEnd) {
  EXPECT_EQ(RunDirectory::create(run, some_facts(), "").outcome(), std::nullopt);
}

TEST_F(RunDirectoryTest, GivesTheOutcomeBack) {
  const auto directory = RunDirectory::create(run, some_facts(), "");
  directory.write_outcome(an_outcome());

  EXPECT_EQ(directory.outcome(), an_outcome());
}

TEST_F(RunDirectoryTest, KeepsTheOutcomeItHasWhenTheDiskIsFull) {
  const auto directory = RunDirectory::create(run, some_facts(), "");
  directory.write_outcome(an_outcome());
  RunOutcome other = an_outcome();
  other.ticks = 1;
  {
    const FullDisk full(10);
    EXPECT_THROW(directory.write_outcome(other), RecordError);
  }
  EXPECT_EQ(directory.outcome(), an_outcome());
}

TEST_F(RunDirectoryTest, SaysThatAPathIsNoRunDirectory) {
  EXPECT_EQ(open_complaint(), run.string() + ": is not a directory, wanted a run directory");

  std::filesystem::create_directories(run);
  EXPECT_EQ(open_complaint(), run.string() + ": holds no run.json, wanted a run directory");
}

TEST_F(RunDirectoryTest, SaysWhichFactIsWrong) {
  (void)RunDirectory::create(run, some_facts(), "");
  std::string text = text_of(run / "run.json");
  text.replace(text.find("9007199254740993"), 16, "\"seven\"");
  put(run / "run.json", text);

  EXPECT_EQ(open_complaint(),
            (run / "run.json").string() + ": seed: found \"seven\", wanted a whole number");
}

TEST_F(RunDirectoryTest, SaysWhichFactIsMissing) {
  std::filesystem::create_directories(run);
  put(run / "run.json", "{}");

  EXPECT_EQ(open_complaint(), (run / "run.json").string() + ": key: found nothing, wanted a text");
}

TEST_F(RunDirectoryTest, FactsCutAtAnyByteAreRefused) {
  (void)RunDirectory::create(run, some_facts(), "");
  const std::string whole = text_of(run / "run.json");
  for (std::size_t kept = 0; kept + 2 < whole.size(); ++kept) {
    put(run / "run.json", whole.substr(0, kept));
    ASSERT_EQ(open_complaint(), (run / "run.json").string() + ": is not a JSON object") << kept;
  }
}

TEST_F(RunDirectoryTest, AnOutcomeWithATextForAMetricIsRefused) {
  const auto directory = RunDirectory::create(run, some_facts(), "");
  std::string text = to_json(an_outcome());
  text.replace(text.find("\"created\": 7"), 12, "\"created\": \"7\"");
  put(directory.metrics_file(), text);

  EXPECT_EQ(complaint<ConfigError>([&] { (void)directory.outcome(); }),
            directory.metrics_file().string() + ": created: found \"7\", wanted a number or null");
}

TEST(RunOutcome, HasASpeedOnceTimeWasMeasured) {
  EXPECT_EQ(an_outcome().ticks_per_s(), 2000.0);
  EXPECT_EQ(RunOutcome().ticks_per_s(), std::nullopt);
}

TEST(RunOutcome, FindsAMetricByItsKey) {
  EXPECT_EQ(an_outcome().metric("created"), 7.0);
  EXPECT_EQ(an_outcome().metric("idle_m"), std::nullopt);
  EXPECT_EQ(an_outcome().metric("altitude_m"), std::nullopt);
}

}  // namespace
}  // namespace tacit
