#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "idl/cdl/model.h"

namespace tacit::cdl {

/// Writes a mission, each part as it stands in the source where it is unchanged. Used once.
///
/// An `origin` is the part of the mission in the source that a part was read from, null for a part
/// that is new.
class Printer {
 public:
  explicit Printer(std::string_view source) : source_(source) {}

  [[nodiscard]] std::string print(const Mission& mission, const Mission& origin);

 private:
  /// A team needs no `;` behind it unless another one follows.
  void end_team_before(const Statement& next, const Mission& mission);
  void statement(const Statement& statement, const Statement* origin);
  void heading(const Statement& statement);
  void expression(const Expression& expression, const Expression* origin, int depth);
  void open(const Expression& expression);
  void close(const Expression& expression, int depth);
  void items(const Expression& expression, const Expression* origin, int depth);
  void item(const Item& item, const Item* origin, int depth);
  void slot(const Slot& slot);
  void comments(const Comments& comments, int depth);
  void new_line(int depth);
  void headings(const std::optional<Place>& place, const std::optional<std::string>& description,
                std::string_view between);
  void copy(std::uint32_t begin, std::uint32_t end);

  std::string_view source_;
  std::string out_;
};

}  // namespace tacit::cdl
