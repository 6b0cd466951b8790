#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "idl/cdl/value.h"

namespace tacit::cdl {

enum class Use { Behaviour, Trigger };

/// What a parameter takes.
enum class ParameterKind { Number, Point, Flag, Word, Words, Text };

/// One parameter of a behaviour or trigger. A word whose parameters are none or not known here has
/// one row without a parameter.
struct VocabularyRow {
  std::string_view word;
  Use use;
  std::string_view parameter;
  ParameterKind kind;
  std::string_view unit;           ///< Empty: none.
  std::string_view default_value;  ///< As written between braces; empty: must be given.
  double low;                      ///< Of a number.
  double high;
};

/// The behaviours and triggers of MissionLab's AuRA.urban, with their parameters; the rows of a
/// word stand together.
[[nodiscard]] std::span<const VocabularyRow> vocabulary();

/// Of one word; empty when it is not known for this use.
[[nodiscard]] std::span<const VocabularyRow> parameters_of(std::string_view word, Use use);

/// All of one use, each once.
[[nodiscard]] std::vector<std::string> words_for(Use use);

/// Why `value` cannot be that parameter: what it takes; none when it can. A value from above can.
[[nodiscard]] std::optional<std::string> misfit(const VocabularyRow& row, const Value& value);

}  // namespace tacit::cdl
