#include "wizard_service/cases/cbl_blocks.h"

#include <algorithm>
#include <array>
#include <string>

#include "idl/types/config_error.h"
#include "wizard_service/cases/cbl.h"

namespace tacit::cbr {
namespace {

/// The blocks that mean something, and where they stand; top is empty.
struct BlockRow {
  std::string_view key;
  std::string_view inside;
};
constexpr std::array<BlockRow, 15> kBlocks{{
    {"DATA", ""},
    {"PLAN", "DATA"},
    {"OPERATOR", "PLAN"},
    {"OPERATOR-PARM", "OPERATOR"},
    {"OPERATOR-EFFECT", "OPERATOR"},
    {"OPERATOR-EFFECT-PARM", "OPERATOR-EFFECT"},
    {"DECISIONTREE", ""},
    {"NODE", "DECISIONTREE"},
    {"NODE", "NODE-EDGE-NEXTNODE"},
    {"NODE-EDGE", "NODE"},
    {"NODE-EDGE-NEXTNODE", "NODE-EDGE"},
    {"NODE-DATA", "NODE"},
    {"NODE-DATA-INDEXES", "NODE-DATA"},
    {"NODE-DATA-STATUSES", "NODE-DATA"},
    {"NODE-DATA-OTHERFEATURE", "NODE-DATA"},
}};

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool is_known(std::string_view key) {
  return std::any_of(kBlocks.begin(), kBlocks.end(),
                     [&](const BlockRow& row) { return row.key == key; });
}

bool fits(std::string_view key, std::string_view inside) {
  return std::any_of(kBlocks.begin(), kBlocks.end(),
                     [&](const BlockRow& row) { return row.key == key && row.inside == inside; });
}

struct Open {
  std::string_view key;
  std::size_t line = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view name) : name_(name) {}

  void read(std::string_view line) {
    ++line_;
    line = trimmed(line);
    if (line.empty()) return;
    const std::size_t blank = std::min(line.find_first_of(kBlanks), line.size());
    const std::string_view key = line.substr(0, blank);
    const std::string_view value = trimmed(line.substr(blank));
    if (!key.ends_with("-NAME") && !key.ends_with("-VALUE") && value == "START") {
      open(key);
    } else if (!key.ends_with("-NAME") && !key.ends_with("-VALUE") && value == "END") {
      close(key);
    } else if (unknown_ == 0) {
      take(key, value);
    }
  }

  CblBlocks finish() {
    if (!open_.empty()) {
      refuse("the file ends within " + std::string(open_.back().key) + " of line " +
             std::to_string(open_.back().line));
    }
    return std::move(blocks_);
  }

 private:
  [[noreturn]] void refuse(const std::string& text) const {
    throw ConfigError(name_ + ':' + std::to_string(line_) + ": " + text);
  }

  [[nodiscard]] std::string_view inside() const {
    return open_.empty() ? std::string_view() : open_.back().key;
  }
  CblCase& one() { return blocks_.cases.back(); }
  CblPlan& plan() { return one().plans.back(); }
  CblOperator& step() { return plan().operators.back(); }
  CblLeaf& leaf() { return blocks_.leaves.back(); }

  void open(std::string_view key) {
    if (open_.size() == kDeepestCbl) refuse("found blocks too deep in each other");
    if (unknown_ > 0 || !is_known(key)) {
      ++unknown_;
    } else if (!fits(key, inside())) {
      refuse("found " + std::string(key) + (open_.empty() ? " at the top" : " in ") +
             std::string(inside()));
    } else {
      begin(key);
    }
    open_.push_back({key, line_});
  }

  void begin(std::string_view key) {
    if (key == "DATA") {
      if (blocks_.cases.size() == kMostCblCases) refuse("found too many cases");
      blocks_.cases.push_back({{}, line_});
    } else if (key == "PLAN") {
      one().plans.push_back({{}, 0, line_});
    } else if (key == "OPERATOR") {
      if (plan().operators.size() == kMostOperators) refuse("found too many operators in a plan");
      plan().operators.emplace_back();
    } else if (key == "OPERATOR-PARM") {
      step().call.parameters.emplace_back();
    } else if (key == "OPERATOR-EFFECT") {
      if (++plan().effects > kMostEffects) refuse("found too many effects in a plan");
      step().effects.emplace_back();
    } else if (key == "OPERATOR-EFFECT-PARM") {
      step().effects.back().parameters.emplace_back();
    } else if (key == "NODE-EDGE") {
      way_.emplace_back();
    } else if (key == "NODE-DATA") {
      blocks_.leaves.push_back({{}, {}, way_, line_});
    } else if (key == "NODE-DATA-OTHERFEATURE") {
      leaf().features.emplace_back();
    }
  }

  void close(std::string_view key) {
    if (open_.empty()) refuse("found the end of " + std::string(key) + ", which did not begin");
    // MissionLab writes no end of a leaf's node.
    if (open_.back().key == "NODE" && key == "NODE-EDGE-NEXTNODE") close("NODE");
    if (open_.back().key != key) {
      refuse("found the end of " + std::string(key) + ", wanted that of " +
             std::string(open_.back().key) + " of line " + std::to_string(open_.back().line));
    }
    if (unknown_ > 0) {
      --unknown_;
    } else if (key == "NODE-EDGE") {
      way_.pop_back();
    }
    open_.pop_back();
  }

  void take(std::string_view key, std::string_view value) {
    const std::string_view in = inside();
    if (in.starts_with("OPERATOR")) {
      take_of_plan(in, key, value);
    } else if (in == "NODE-EDGE") {
      if (key == "NODE-EDGE-PARENT") way_.back().name = value;
      if (key == "NODE-EDGE-VALUE") way_.back().value = value;
    } else if (key == "NODE-DATA-INDEX" && in == "NODE-DATA-INDEXES") {
      leaf().indexes.push_back(value);
    } else if (key == "NODE-DATA-STATUS" && in == "NODE-DATA-STATUSES") {
      leaf().statuses.push_back(value);
    } else if (in == "NODE-DATA-OTHERFEATURE") {
      if (key == "NODE-DATA-OTHERFEATURE-NAME") leaf().features.back().name = value;
      if (key == "NODE-DATA-OTHERFEATURE-VALUE") leaf().features.back().value = value;
    }
  }

  void take_of_plan(std::string_view in, std::string_view key, std::string_view value) {
    const bool of_effect = in.starts_with("OPERATOR-EFFECT");
    CblCall& call = of_effect ? step().effects.back() : step().call;
    if (!key.starts_with(in)) return;
    key.remove_prefix(in.size());
    const bool is_parameter = in.ends_with("-PARM");
    if (is_parameter && key == "-NAME") call.parameters.back().name = value;
    if (is_parameter && key == "-VALUE") call.parameters.back().value = value;
    if (!is_parameter && key == "-NAME") call.name = value;
    if (!is_parameter && key == "-INDEX") call.index = value;
  }

  std::string name_;
  std::size_t line_ = 0;
  std::vector<Open> open_;
  std::size_t unknown_ = 0;   ///< Open blocks that are not known, and all within.
  std::vector<CblPair> way_;  ///< To the node that is being read.
  CblBlocks blocks_;
};

}  // namespace

CblBlocks cbl_blocks(std::string_view text, std::string_view name) {
  if (text.size() > kLongestCbl || text.find('\0') != std::string_view::npos) {
    throw ConfigError(std::string(name) + ": found " +
                      (text.size() > kLongestCbl ? "more than 64 MB" : "a NUL") +
                      ", wanted a case library (.cbl)");
  }
  Reader reader(name);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::string_view line = text.substr(0, end + 1);
    reader.read(line.ends_with('\n') ? line.substr(0, line.size() - 1) : line);
    text.remove_prefix(end + 1);
  }
  CblBlocks blocks = reader.finish();
  if (blocks.cases.empty()) {
    throw ConfigError(std::string(name) + ": found no case, wanted a case library (.cbl)");
  }
  return blocks;
}

}  // namespace tacit::cbr
