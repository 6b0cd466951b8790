#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "idl/cdl/finding.h"
#include "idl/cdl/names.h"
#include "idl/cdl/vocabulary.h"

namespace tacit::cdl {

/// Walks a mission once. Used once.
class Checker {
 public:
  explicit Checker(const Mission& mission);
  [[nodiscard]] Findings run();

 private:
  /// What a name may stand for.
  enum class Wanted {
    Statement,  ///< One of the file's own.
    Behaviour,  ///< Of the file or of the library.
    Trigger,
    Any,
  };
  using States = std::map<std::string_view, const Item*>;

  void walk(const Expression& expression, Wanted wanted);
  void reference(const Expression& reference, Wanted wanted);
  void undefined(const Expression& reference);
  void unknown(const Expression& reference, Wanted wanted);
  void parameters(const Expression& group, Wanted wanted);
  void parameter(const Item& item, const Expression& body, std::span<const VocabularyRow> known);

  void automaton(const Expression& instance);
  States states(const Expression& instance);
  void rules(const Expression& instance, const States& states);
  void reachable(const Expression& instance, const States& states);
  void dead_ends(const Expression& instance, const States& states);

  void doubles();
  void circles();
  [[nodiscard]] std::string hint(std::string_view name,
                                 const std::vector<std::string>& known) const;
  void find(Severity severity, const char* rule, std::string text, const Span& span);

  const Mission& mission_;
  Names names_;
  std::vector<std::string> known_names_;
  std::vector<std::vector<const Expression*>> references_;  ///< Of each statement.
  std::size_t statement_ = 0;
  FindingList findings_;
};

}  // namespace tacit::cdl
