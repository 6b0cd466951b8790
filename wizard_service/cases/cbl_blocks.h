#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace tacit::cbr {

/// All views are of the text that was read.
struct CblPair {
  std::string_view name;
  std::string_view value;
};

/// A behaviour in its state, or a trigger and the state it leads to.
struct CblCall {
  std::string_view name;
  std::string_view index;
  std::vector<CblPair> parameters;
};

struct CblOperator {
  CblCall call;
  std::vector<CblCall> effects;
};

struct CblPlan {
  std::vector<CblOperator> operators;
  std::size_t effects = 0;  ///< Of all operators.
  std::size_t line = 0;
};

struct CblCase {
  std::vector<CblPlan> plans;
  std::size_t line = 0;
};

struct CblLeaf {
  std::vector<std::string_view> indexes;
  std::vector<std::string_view> statuses;
  std::vector<CblPair> features;  ///< Those on the way first.
  std::size_t line = 0;
};

/// What the blocks of a `.cbl` file say, not yet checked for sense.
struct CblBlocks {
  std::vector<CblCase> cases;
  std::vector<CblLeaf> leaves;
};

/// Throws ConfigError with `name` and the line when blocks do not end where they should, stand
/// where they cannot or are too many or too deep.
[[nodiscard]] CblBlocks cbl_blocks(std::string_view text, std::string_view name);

}  // namespace tacit::cbr
