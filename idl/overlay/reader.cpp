#include "idl/overlay/reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "idl/overlay/statement.h"
#include "idl/overlay/tokens.h"

namespace tacit {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Whether a line that begins with `token` goes on with the statement before.
bool goes_on_with(const MapToken& token) {
  constexpr std::array<std::string_view, 3> kInner{"CENTERLINE", "WIDTH", "EXTENTS"};
  return token.kind == MapToken::Kind::Number ||
         (token.kind == MapToken::Kind::Word &&
          std::find(kInner.begin(), kInner.end(), capitals(token.text)) != kInner.end());
}

/// About how many statements begin in `text`, at least one.
std::size_t statements_in(std::string_view text) {
  std::size_t count = 1;
  bool begins = false;
  for (const char c : text) {
    count += begins && ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) ? 1 : 0;
    begins = c == '\n';
  }
  return count;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  OverlayReading read() {
    note_zero_byte();
    // Moving a million statements to a larger place takes longer than reading them.
    reading_.map.statements.reserve(std::min(statements_in(text_), kMostStatements));
    std::size_t at = text_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    for (std::uint32_t line = 1; at < text_.size() && !full_; ++line) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      take_line(at, end, line);
      at = end + 1;
    }
    finish();
    reading_.map.ending = text_.substr(kept_);
    return std::move(reading_);
  }

 private:
  /// Warnings leave room for errors.
  void note(Severity severity, MapSpot at, const std::string& text) {
    const bool error = severity == Severity::Error;
    std::size_t& told = error ? errors_ : warnings_;
    if (++told <= kMostFindings / 2) {
      reading_.findings.push_back({severity, at, text});
    }
  }

  void note_zero_byte() {
    const std::size_t zero = text_.find('\0');
    if (zero == std::string_view::npos) return;
    const std::string_view before = text_.substr(0, zero);
    const auto line = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    note(Severity::Error, {line + 1, static_cast<std::uint32_t>(zero - line_begin + 1)},
         "found a byte 0, wanted a text file");
  }

  void take_line(std::size_t begin, std::size_t end, std::uint32_t line) {
    line_.clear();
    const auto open_quote = add_tokens(text_, begin, end, line, line_);
    if (line_.empty()) return;
    const bool goes_on = !tokens_.empty() && goes_on_with(line_.front());
    if (!goes_on) finish();
    last_ = line_.back().end;
    if (open_quote) {
      open_quote_ = open_quote;
    }
    const std::size_t room = kMostWords - std::min(kMostWords, tokens_.size());
    too_long_ = too_long_ || line_.size() > room;
    const auto taken = static_cast<std::ptrdiff_t>(std::min(room, line_.size()));
    tokens_.insert(tokens_.end(), line_.begin(), line_.begin() + taken);
  }

  /// The statement in `tokens_` is whole.
  void finish() {
    if (tokens_.empty() || full_) return;
    if (reading_.map.statements.size() == kMostStatements) {
      full_ = true;
      note(Severity::Error, tokens_.front().at,
           "found more than " + std::to_string(kMostStatements) + " statements, wanted fewer");
      return;
    }
    MapStatement statement;
    const std::size_t begin = tokens_.front().begin;
    statement.at = tokens_.front().at;
    statement.before = text_.substr(kept_, begin - kept_);
    statement.spelled = text_.substr(begin, last_ - begin);
    statement.content = content();
    if (auto* unknown = std::get_if<MapUnknown>(&statement.content)) {
      unknown->text = statement.spelled;
    }
    reading_.map.statements.push_back(std::move(statement));
    kept_ = last_;
    tokens_.clear();
    open_quote_.reset();
    too_long_ = false;
  }

  MapContent content() {
    try {
      require_whole();
      MapContent content = content_of(tokens_);
      if (std::holds_alternative<MapUnknown>(content)) note_unknown(tokens_.front());
      return content;
    } catch (const MapRefusal& refusal) {
      note(refusal.finding.severity, refusal.finding.at, refusal.finding.text);
      return MapUnknown{};
    }
  }

  void require_whole() const {
    if (open_quote_) {
      throw MapRefusal{{Severity::Error, *open_quote_,
                        "found the end of the line in a text, wanted a \" before it"}};
    }
    if (too_long_) {
      throw MapRefusal{{Severity::Error, tokens_.back().at,
                        "found more than " + std::to_string(kMostWords) +
                            " words in one statement, wanted fewer"}};
    }
  }

  void note_unknown(const MapToken& token) {
    if (warnings_ >= kMostFindings / 2) return;  // A guess takes longer than the reading.
    const std::string_view near = nearest_keyword(token.text);
    const std::string text =
        refusal(token, "a statement of a map; it is kept, not used").finding.text;
    note(Severity::Warning, token.at,
         text + (near.empty() ? "" : ", did you mean " + std::string(near) + "?"));
  }

  std::string_view text_;
  OverlayReading reading_;
  std::vector<MapToken> line_;
  std::vector<MapToken> tokens_;  ///< Of the statement that is being read.
  std::optional<MapSpot> open_quote_;
  bool too_long_ = false;
  bool full_ = false;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  std::size_t last_ = 0;  ///< Where its last word ends.
  std::size_t kept_ = 0;  ///< Up to where the text lies in statements.
};

}  // namespace

OverlayReading read_overlay(std::string_view text) { return Reader(text).read(); }

}  // namespace tacit
