// The wizard as people meet it: `tacit wizard`, `tacit plan` and other clients, as processes.

#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "idl/bus/domain_lease.h"
#include "idl/bus/wizard_post.h"
#include "tests/cases/some_cases.h"
#include "tests/process/programs.h"
#include "wizard_service/cases/case_base.h"
#include "wizard_service/client/wizard_client.h"

namespace tacit {
namespace {

using cbr::testing::shipped_case;
using nlohmann::json;
using namespace std::chrono_literals;

std::string shipped(const std::string& file) {
  return cbr::testing::text_of(std::string(TACIT_SOURCE_DIR) + "/deploy/" + file);
}

/// A mission that stands still for so many states and is over. Of another number it is another.
cbr::Case idle_case(int states = 1) {
  cbr::RobotPlan robot;
  robot.name = "Idler";
  for (int i = 0; i < states; ++i) {
    const std::string name = i == 0 ? "Start" : "$AN_" + std::to_string(i);
    robot.states.push_back({name,
                            name,
                            cbr::behaviour("Stop"),
                            {{cbr::behaviour("Immediate"), "$AN_" + std::to_string(i + 1)}}});
  }
  robot.states.push_back(
      {"$AN_" + std::to_string(states), "Done", cbr::behaviour("Terminate"), {}});
  cbr::Case one;
  one.title = "Idle";
  one.origin = "test";
  one.features = cbr::usual_features(Task::Biohazard);
  one.plan.robots = {robot};
  return one;
}

/// A wizard of its own.
class WizardProcess : public testing::Test {
 protected:
  WizardProcess() : lease_(DomainLease::take(kWizardNonce)) {}

  [[nodiscard]] std::string cases() const { return scratch_ / "cases.db"; }
  [[nodiscard]] std::string domain() const { return std::to_string(lease_.domain()); }

  void serve() {
    wizard_ = std::make_unique<Running>(std::vector<std::string>{
        program("wizard_service"), "--domain", domain(), "--cases", cases()});
    ASSERT_TRUE(becomes_true([&] { return WizardPost::is_held(lease_.domain()); }));
  }
  [[nodiscard]] Finished stop() {
    wizard_->send(SIGTERM);
    return wizard_->finish(10s);
  }
  void kill() {
    wizard_->send(SIGKILL);
    (void)wizard_->finish(10s);
    wizard_.reset();
  }

  [[nodiscard]] WizardClient client(std::chrono::milliseconds patience = 20s) const {
    return WizardClient({lease_.domain(), patience});
  }

  [[nodiscard]] std::vector<std::string> plan_words(std::vector<std::string> more) const {
    std::vector<std::string> words{"plan", "--map", "office", "--domain", domain()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static AskForPlans ask_for_biohazard() {
    AskForPlans ask;
    ask.request.tasks = {{Task::Biohazard, 20.0, 22.0, {}, {}, {}}};
    ask.request.robots = 1;
    ask.map = shipped("maps/office.ovl");
    return ask;
  }

  Scratch scratch_;
  DomainLease lease_;
  std::unique_ptr<Running> wizard_;
};

TEST_F(WizardProcess, PlansForAPersonWhetherItServesOrNot) {
  std::vector<std::string> words =
      plan_words({"--task", "biohazard@hallway", "--robots", "1", "--json"});
  serve();
  const Finished served = tacit(words);
  ASSERT_EQ(served.exit_code, 0) << served.err;
  EXPECT_EQ(stop().exit_code, 0);
  words.insert(words.end(), {"--cases", cases()});
  const Finished alone = tacit(words);
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(served.out, alone.out);
  const json answer = json::parse(served.out);
  ASSERT_FALSE(answer["plans"].empty());
  EXPECT_EQ(answer["plans"][0]["cases"][0]["features"][0]["found"], "BiohazardTask");
  EXPECT_NE(answer["plans"][0]["mission"].get<std::string>().find("Planned from cases."),
            std::string::npos);
}

TEST_F(WizardProcess, TellsWhetherItServes) {
  EXPECT_EQ(tacit({"wizard", "--status", "--domain", domain()}).exit_code, 4);
  serve();
  const Finished finished = tacit({"wizard", "--status", "--domain", domain()});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_NE(finished.out.find("Has "), std::string::npos);
}

TEST_F(WizardProcess, IsTheOnlyOneOnItsDomain) {
  serve();
  Running second({program("wizard_service"), "--domain", domain(), "--cases", cases()});
  const Finished finished = second.finish(10s);
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_NE(finished.err.find("a wizard serves domain"), std::string::npos) << finished.err;
}

TEST_F(WizardProcess, AnswersTenClientsAtOnceEachWithItsOwn) {
  serve();
  std::vector<std::thread> threads;
  std::vector<std::string> wrong(10);
  for (int i = 0; i < 10; ++i) {
    threads.emplace_back([&, i] {
      WizardClient mine = client();
      for (int k = 0; k < 5; ++k) {
        AskForPlans ask = ask_for_biohazard();
        ask.request.max_velocity_mps = 0.1 + 0.01 * (5 * i + k);
        const WizardClient::Reply reply = mine.ask(ask);
        const auto* answer = std::get_if<PlanAnswer>(&reply);
        char speed[32];
        std::snprintf(speed, sizeof speed, "%.2f m/s", ask.request.max_velocity_mps);
        std::string told;
        for (const PlanChange& change :
             answer ? answer->plans.at(0).changes : std::vector<PlanChange>()) {
          if (change.rule == "speed") told = change.after;
        }
        // "0.50 m/s" is told as "0.5 m/s".
        const double found = told.empty() ? 0.0 : std::stod(told);
        if (std::abs(found - ask.request.max_velocity_mps) > 1e-9) {
          wrong[static_cast<std::size_t>(i)] += told + " instead of " + speed + '\n';
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : wrong) EXPECT_EQ(text, "");
}

TEST_F(WizardProcess, OutlivesClientsThatVanish) {
  serve();
  for (int i = 0; i < 3; ++i) {
    Running gone(tacit_words(plan_words({"--task", "biohazard@hallway"})));
    std::this_thread::sleep_for(50ms * i);
    gone.send(SIGKILL);
    (void)gone.finish(10s);
  }
  EXPECT_EQ(tacit(plan_words({"--task", "biohazard@hallway"})).exit_code, 0);
}

/// Stores one mission after the other until the wizard says nothing any more; adds to `stored` what
/// it said it did.
void store_until_silent(WizardClient hasty, std::uint64_t& stored) {
  try {
    for (;;) {
      const cbr::Case one = idle_case(1 + static_cast<int>(stored));
      const WizardClient::Reply reply =
          hasty.ask(StoreMission{cbr::mission_text(one.plan), "Idle", {one.features}});
      EXPECT_TRUE(std::holds_alternative<WizardDone>(reply));
      ++stored;
    }
  } catch (const WizardSilent&) {
  }
}

TEST_F(WizardProcess, LosesNothingThatItSaidItStoredWhenItIsKilled) {
  serve();
  const std::uint64_t before = cbr::CaseBase(cases()).size();
  std::uint64_t stored = 0;
  for (int round = 0; round < 3; ++round) {
    std::thread killer([&] {
      std::this_thread::sleep_for(700ms);
      wizard_->send(SIGKILL);
    });
    store_until_silent(client(1500ms), stored);
    killer.join();
    kill();
    cbr::CaseBase base(cases());
    EXPECT_TRUE(base.flaws().empty());
    EXPECT_GE(base.size(), before + stored);
    // One may have been stored and its answer lost.
    EXPECT_LE(base.size(), before + stored + 1);
    serve();
  }
  EXPECT_GT(stored, 3U);
}

TEST_F(WizardProcess, IsFoundAgainByItsClientsWhenItWasStartedAnew) {
  serve();
  WizardClient mine = client();
  ASSERT_TRUE(std::holds_alternative<WizardDone>(mine.ask(AskForState{})));
  kill();
  serve();
  EXPECT_TRUE(std::holds_alternative<WizardDone>(mine.ask(AskForState{})));
}

TEST_F(WizardProcess, GivesABetterPlanAfterABadRunAndKeepsAGoodOne) {
  {
    cbr::CaseBase base(cases());
    base.store(idle_case());
    base.store(shipped_case("biohazard", Task::Biohazard));
  }
  serve();
  const auto flown = [&](const std::string& run, std::vector<std::string> more) {
    std::vector<std::string> words = plan_words(
        {"--task", "biohazard@hallway", "--robots", "1", "--run", "--json", "--quiet", "--run-out",
         (scratch_ / run).string(), "--run-store", (scratch_ / "runs.db").string()});
    words.insert(words.end(), more.begin(), more.end());
    const Finished finished = tacit(words);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return json::parse(finished.out, nullptr, false)["checklist"];
  };
  const json bad = flown("bad", {});
  EXPECT_LT(bad["done"], bad["wanted"]);
  const Finished next = tacit(plan_words({"--task", "biohazard@hallway", "--robots", "1"}));
  EXPECT_NE(next.out.find("case 2"), std::string::npos) << next.out;
  EXPECT_LT(next.out.find("case 2"), next.out.find("case 1")) << next.out;
  EXPECT_NE(next.out.find("of 1 outcomes good"), std::string::npos) << next.out;
  const json good = flown("good", {"--store", "--title", "As flown"});
  EXPECT_EQ(good["done"], good["wanted"]) << good.dump(2);
  EXPECT_EQ(stop().exit_code, 0);
  cbr::CaseBase base(cases());
  EXPECT_EQ(base.find(1).record.failures.empty(), false);
  EXPECT_EQ(base.find(2).record.good_milli, 1000U);
  EXPECT_EQ(base.find(2).record.uses, 1U);
}

TEST_F(WizardProcess, SaysWhatIsWrongAndGoesOn) {
  serve();
  const auto error = [&](std::vector<std::string> more, int exit_code = 2) {
    const Finished finished = tacit(plan_words(std::move(more)));
    EXPECT_EQ(finished.exit_code, exit_code) << finished.out << finished.err;
    return finished.err;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? std::string() : text;
  };
  EXPECT_EQ(has(error({"--task", "biohazard"}), "wanted KIND@X,Y"), "");
  EXPECT_EQ(has(error({"--task", "picnic@1,2"}), "picnic"), "");
  EXPECT_EQ(has(error({"--task", "biohazard@Kitchen"}), "Library"), "");
  EXPECT_EQ(has(error({"--task", "biohazard@1,2/wet"}), "/indoor"), "");
  EXPECT_EQ(has(error({"--task", "biohazard@9999,2"}), "wanted a place on the map"), "");
  const std::vector<std::string> task{"--task", "biohazard@hallway"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), task.begin(), task.end());
    return more;
  };
  EXPECT_EQ(has(error(with({"--robots", "0"})), "found 0"), "");
  EXPECT_EQ(has(error(with({"--robots", "1000"})), "found 1000"), "");
  EXPECT_EQ(has(error(with({"--aggressiveness", "7"})), "found 7"), "");
  EXPECT_EQ(has(error(with({"--top", "0"})), "found 0"), "");
  EXPECT_EQ(has(error(with({"--choose", "9", "--top", "1", "--store"})), "wanted 1 to 1"), "");
  const Finished no_map = tacit({"plan", "--map", "nowhere", "--task", "biohazard@1,2"});
  EXPECT_EQ(no_map.exit_code, 2);
  EXPECT_EQ(tacit(plan_words(task)).exit_code, 0);
}

TEST_F(WizardProcess, RefusesADamagedCaseBaseAndLeavesItAsItIs) {
  const std::string noise(5000, 'x');
  std::ofstream(cases()) << noise;
  const Finished finished =
      tacit(plan_words({"--task", "biohazard@hallway", "--cases", cases(), "--patience", "20"}));
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_NE(finished.err.find("wanted a case base"), std::string::npos) << finished.err;
  EXPECT_EQ(text_of(cases()), noise);
}

TEST_F(WizardProcess, IsGivenUpWhenItSaysNothing) {
  EXPECT_THROW((void)client(200ms).ask(AskForState{}), WizardSilent);
}

TEST_F(WizardProcess, IsNotWaitedForWhenNobodyWantsAnAnswer) {
  const WizardClient::Reply reply = client().ask(AskForState{}, {}, [] { return true; });
  EXPECT_EQ(std::get<WizardRefusal>(reply).text, "cancelled");
}

}  // namespace
}  // namespace tacit
