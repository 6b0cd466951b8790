#include "wizard_service/cases/case_base.h"

#include <algorithm>
#include <list>
#include <optional>
#include <set>
#include <utility>

#include "wizard_service/cases/case_file.h"
#include "wizard_service/cases/case_row.h"
#include "wizard_service/cbr/plan_cdl.h"
#include "wizard_service/cbr/rank.h"
#include "wizard_service/cbr/store.h"

namespace tacit::cbr {
namespace {

constexpr const char* kInsert = R"sql(
  INSERT INTO cases (title, origin, task, robots, localization, environment, handles_enemy, plan,
                     plan_sum, likeness, uses, outcomes, good_milli, created)
  VALUES (:title, :origin, :task, :robots, :localization, :environment, :handles_enemy, :plan,
          :plan_sum, :likeness, :uses, :outcomes, :good_milli,
          strftime('%Y-%m-%dT%H:%M:%SZ', 'now'))
)sql";

constexpr const char* kSame = R"sql(
  SELECT id FROM cases
  WHERE likeness = :likeness AND task = :task AND robots = :robots
    AND localization = :localization AND environment = :environment
    AND handles_enemy = :handles_enemy
)sql";

constexpr const char* kRecord = R"sql(
  UPDATE cases SET uses = :uses, outcomes = :outcomes, good_milli = :good_milli WHERE id = :id
)sql";

std::int64_t key(CaseId id) { return static_cast<std::int64_t>(id); }

/// The mission that `plan` is. Throws ConfigError when it would not read back.
std::string readable_text(const Case& one) {
  std::string text = mission_text(one.plan);
  const std::string name = one.title.empty() ? "case" : "case \"" + one.title + '"';
  if (plan_of(text, name) != one.plan) {
    throw ConfigError(name + ": has a plan that cannot be written as a mission");
  }
  return text;
}

/// What changes when anybody writes.
struct Look {
  std::int64_t by_others = 0;
  std::uint64_t by_us = 0;
  friend bool operator==(const Look&, const Look&) = default;
};

struct Kept {
  Case one;
  Look seen;
};

}  // namespace

class CaseBase::Impl {
 public:
  explicit Impl(const std::filesystem::path& file) : file_(file) {}

  template <class Work>
  decltype(auto) attempt(Work work) {
    return file_.attempt(work);
  }

  template <class Work>
  void write(Work work) {
    attempt([&] {
      SQLite::Transaction transaction(db(), SQLite::TransactionBehavior::IMMEDIATE);
      work();
      transaction.commit();
      ++writes_;
    });
  }

  /// Calls `use` with a statement that stands on each usable row in turn, `leave` with each flaw.
  template <class Use, class Leave>
  void walk(Use use, Leave leave) {
    attempt([&] {
      SQLite::Statement found(db(), "SELECT * FROM cases ORDER BY id");
      while (found.executeStep()) {
        if (std::optional<std::string> flaw = flaw_of(found)) {
          leave(Flaw{static_cast<CaseId>(found.getColumn("id").getInt64()), std::move(*flaw)});
        } else {
          use(found);
        }
      }
    });
  }

  Stored insert(const Case& one, const std::string& text, const std::string& likeness);
  [[nodiscard]] bool is_there(CaseId id);
  /// False when it is known already.
  [[nodiscard]] bool note_report(const ReportKey& by);
  void take_in(CaseId id, double score, const std::vector<Failure>& failures, std::uint32_t uses);
  void add_failures(CaseId id, const std::vector<Failure>& failures);
  std::vector<Failure> failures_of(CaseId id);
  CaseRow row(CaseId id);
  const Case& found(CaseId id);
  Look look();

  [[nodiscard]] SQLite::Database& db() { return file_.db(); }
  [[nodiscard]] std::string name(CaseId id) const {
    return file_.path().string() + ": case " + std::to_string(id);
  }
  [[nodiscard]] bool changed() {
    const Look now = attempt([&] { return look(); });
    return std::exchange(looked_, now) != now;
  }

 private:
  CaseFile file_;
  std::uint64_t writes_ = 0;
  std::optional<Look> looked_;
  std::list<Kept> kept_;  ///< The last found first.
};

Look CaseBase::Impl::look() { return {db().execAndGet("PRAGMA data_version").getInt64(), writes_}; }

Stored CaseBase::Impl::insert(const Case& one, const std::string& text,
                              const std::string& likeness) {
  SQLite::Statement same(db(), kSame);
  bind(same, one.features);
  same.bind(":likeness", likeness);
  if (same.executeStep()) return {static_cast<CaseId>(same.getColumn(0).getInt64()), false};
  SQLite::Statement statement(db(), kInsert);
  bind(statement, one.features);
  bind(statement, one.record);
  statement.bind(":title", one.title);
  statement.bind(":origin", one.origin);
  statement.bind(":plan", text);
  statement.bind(":plan_sum", sum_of(text));
  statement.bind(":likeness", likeness);
  statement.exec();
  const auto id = static_cast<CaseId>(db().getLastInsertRowid());
  add_failures(id, one.record.failures);
  return {id, true};
}

bool CaseBase::Impl::is_there(CaseId id) {
  SQLite::Statement found(db(), "SELECT 1 FROM cases WHERE id = ?");
  found.bind(1, key(id));
  return found.executeStep();
}

bool CaseBase::Impl::note_report(const ReportKey& by) {
  SQLite::Statement insert(
      db(), "INSERT INTO reports (client, request) VALUES (?, ?) ON CONFLICT DO NOTHING");
  insert.bind(1, static_cast<std::int64_t>(by.client));
  insert.bind(2, static_cast<std::int64_t>(by.request));
  if (insert.exec() == 0) return false;
  SQLite::Statement old(db(), "DELETE FROM reports WHERE number <= ?");
  old.bind(1, db().getLastInsertRowid() - kReportsKept);
  old.exec();
  return true;
}

void CaseBase::Impl::take_in(CaseId id, double score, const std::vector<Failure>& failures,
                             std::uint32_t uses) {
  TrackRecord record = row(id).one.record;
  record.uses += uses;
  take_outcome(record, score);
  for (const Failure& failure : failures) remember_failure(record, failure);
  SQLite::Statement update(db(), kRecord);
  bind(update, record);
  update.bind(":id", key(id));
  update.exec();
  SQLite::Statement old(db(), "DELETE FROM failures WHERE case_id = ?");
  old.bind(1, key(id));
  old.exec();
  add_failures(id, record.failures);
}

void CaseBase::Impl::add_failures(CaseId id, const std::vector<Failure>& failures) {
  for (const Failure& failure : failures) {
    SQLite::Statement statement(db(), "INSERT INTO failures (case_id, what, map) VALUES (?, ?, ?)");
    statement.bind(1, key(id));
    statement.bind(2, failure.what);
    statement.bind(3, failure.map);
    statement.exec();
  }
}

std::vector<Failure> CaseBase::Impl::failures_of(CaseId id) {
  std::vector<Failure> failures;
  SQLite::Statement found(db(), "SELECT what, map FROM failures WHERE case_id = ? ORDER BY number");
  found.bind(1, key(id));
  while (found.executeStep()) {
    failures.push_back({found.getColumn(0).getString(), found.getColumn(1).getString()});
  }
  return failures;
}

CaseRow CaseBase::Impl::row(CaseId id) {
  SQLite::Statement found(db(), "SELECT * FROM cases WHERE id = ?");
  found.bind(1, key(id));
  if (!found.executeStep()) throw ConfigError(name(id) + " is not there");
  CaseRow row = row_of(found);
  row.one.record.failures = failures_of(id);
  return row;
}

const Case& CaseBase::Impl::found(CaseId id) {
  const Look now = look();
  const auto at = std::find_if(kept_.begin(), kept_.end(),
                               [id](const Kept& kept) { return kept.one.id == id; });
  if (at != kept_.end() && at->seen == now) {
    kept_.splice(kept_.begin(), kept_, at);
    return kept_.front().one;
  }
  CaseRow fresh = row(id);
  if (at != kept_.end()) {
    // The plan of an id never changes.
    at->one.record = std::move(fresh.one.record);
    at->seen = now;
    kept_.splice(kept_.begin(), kept_, at);
    return kept_.front().one;
  }
  fresh.one.plan = plan_of(fresh.plan, name(id));
  kept_.push_front({std::move(fresh.one), now});
  if (kept_.size() > kCasesKept) kept_.pop_back();
  return kept_.front().one;
}

CaseBase::CaseBase(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}
CaseBase::~CaseBase() = default;

Stored CaseBase::store(const Case& one) { return store(std::span(&one, 1)).front(); }

std::vector<Stored> CaseBase::store(std::span<const Case> cases) {
  std::vector<std::string> texts;
  std::vector<std::string> likenesses;
  for (const Case& one : cases) {
    texts.push_back(readable_text(one));
    likenesses.push_back(likeness(one.plan));
  }
  std::vector<Stored> stored;
  impl_->write([&] {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      stored.push_back(impl_->insert(cases[i], texts[i], likenesses[i]));
    }
  });
  return stored;
}

const Case& CaseBase::find(CaseId id) {
  return impl_->attempt([&]() -> const Case& { return impl_->found(id); });
}

Inventory CaseBase::inventory() {
  Inventory all;
  impl_->walk(
      [&](SQLite::Statement& found) {
        const CaseRow row = row_of(found);
        const Case& one = row.one;
        all.heads.push_back(
            {one.id, one.features, standing(one.record), mark(one.features, row.plan)});
      },
      [&](Flaw flaw) { all.flaws.push_back(std::move(flaw)); });
  return all;
}

std::vector<CaseHead> CaseBase::heads() { return inventory().heads; }

std::vector<Case> CaseBase::listed() {
  std::vector<Case> cases;
  impl_->walk(
      [&](SQLite::Statement& found) {
        cases.push_back(row_of(found).one);
        cases.back().record.failures = impl_->failures_of(cases.back().id);
      },
      [](const Flaw&) {});
  return cases;
}

std::vector<Flaw> CaseBase::flaws() { return inventory().flaws; }

void CaseBase::record_outcome(CaseId id, double score, const std::vector<Failure>& failures) {
  impl_->write([&] { impl_->take_in(id, score, failures, 0); });
}

bool CaseBase::record_report(const ReportKey& by, std::span<const CaseId> cases, double score,
                             const std::vector<Failure>& failures) {
  bool fresh = false;
  impl_->write([&] {
    fresh = impl_->note_report(by);
    if (!fresh) return;
    const std::set<CaseId> once(cases.begin(), cases.end());
    std::size_t taken = 0;
    for (const CaseId id : once) {
      if (!impl_->is_there(id)) continue;
      impl_->take_in(id, score, failures, 1);
      ++taken;
    }
    if (taken == 0) throw ConfigError("found no case that the report is about");
  });
  return fresh;
}

void CaseBase::remove(CaseId id) {
  impl_->write([&] {
    SQLite::Statement statement(impl_->db(), "DELETE FROM cases WHERE id = ?");
    statement.bind(1, key(id));
    if (statement.exec() == 0) throw ConfigError(impl_->name(id) + " is not there");
  });
}

std::uint64_t CaseBase::size() {
  return impl_->attempt([&] {
    const auto count = impl_->db().execAndGet("SELECT count(*) FROM cases").getInt64();
    return static_cast<std::uint64_t>(count);
  });
}

bool CaseBase::was_used() {
  return impl_->attempt(
      [&] { return impl_->db().execAndGet("SELECT count(*) FROM sqlite_sequence").getInt() != 0; });
}

bool CaseBase::changed_since_last_look() { return impl_->changed(); }

}  // namespace tacit::cbr
