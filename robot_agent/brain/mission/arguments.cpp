#include "robot_agent/brain/mission/arguments.h"

#include <array>
#include <cmath>

#include "idl/types/lowered.h"

namespace tacit {
namespace {

struct ClassWord {
  std::string_view word;  ///< In small letters, singular.
  ThingSet things;
};

constexpr ThingSet kRobots = ThingSet(Thing::Friend) | Thing::Disabled | Thing::Enemy;
constexpr ThingSet kObjects = ThingSet(Thing::Mine) | Thing::Flag | Thing::EodArea | Thing::Rock |
                              Thing::Tree | Thing::Home | Thing::Unknown | Thing::HidingPlace |
                              Thing::Base;

// MissionLab's object classes, by its colours.
constexpr std::array kClassWords{
    ClassWord{"mine", Thing::Mine},
    ClassWord{"enemy", Thing::Enemy},
    ClassWord{"enemy_robot", Thing::Enemy},
    ClassWord{"flag", Thing::Flag},
    ClassWord{"eod_area", Thing::EodArea},
    ClassWord{"eod", Thing::EodArea},
    ClassWord{"rock", Thing::Rock},
    ClassWord{"tree", Thing::Tree},
    ClassWord{"home_base", ThingSet(Thing::Home) | Thing::Base},
    ClassWord{"base", ThingSet(Thing::Home) | Thing::Base},
    ClassWord{"start_place", Thing::Home},
    ClassWord{"unknown_object", Thing::Unknown},
    ClassWord{"unknown", Thing::Unknown},
    ClassWord{"possible_biohazard", Thing::Unknown},
    ClassWord{"possible_x", Thing::Unknown},
    ClassWord{"biohazard", Thing::Unknown},
    ClassWord{"hiding_place", Thing::HidingPlace},
    ClassWord{"hostage", Thing::HidingPlace},
    ClassWord{"friendly_robot", Thing::Friend},
    ClassWord{"friend", Thing::Friend},
    ClassWord{"disabled_robot", Thing::Disabled},
    ClassWord{"banana", Thing::Disabled},
    ClassWord{"robot", kRobots},
    ClassWord{"object", kObjects},
    ClassWord{"any_object", kObjects},
};

/// "mines" to "mine", "enemies" to "enemy".
std::string singular(std::string word) {
  if (word.ends_with("ies")) return word.substr(0, word.size() - 3) + "y";
  if (word.ends_with('s')) word.pop_back();
  return word;
}

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace

ThingSet things_called(std::string_view word) {
  const std::string wanted = singular(lowered(word));
  for (const ClassWord& each : kClassWords) {
    if (each.word == wanted) return each.things;
  }
  return {};
}

std::optional<Colour> colour_of(ThingSet things) {
  if (things == ThingSet(Thing::Mine)) return Colour::Orange;
  if (things == ThingSet(Thing::Flag)) return Colour::Purple;
  if (things == ThingSet(Thing::EodArea)) return Colour::Green;
  if (things == ThingSet(Thing::Rock)) return Colour::Black;
  if (things == ThingSet(Thing::Tree)) return Colour::SeaGreen;
  if (things == ThingSet(Thing::Home)) return Colour::White;
  if (things == ThingSet(Thing::Unknown)) return Colour::Brown;
  if (things == ThingSet(Thing::HidingPlace)) return Colour::LightBlue;
  if (things == ThingSet(Thing::Enemy)) return Colour::Red;
  return std::nullopt;
}

void Arguments::refuse(const std::string& what) const {
  findings_->push_back(
      {cdl::Severity::Error, "parameter", behaviour_->name + ": " + what, place_.begin, 0, 0});
}

const cdl::Value* Arguments::given(std::string_view name) const {
  for (const cdl::Parameter& each : behaviour_->parameters) {
    if (each.name == name) return &each.value;
  }
  return nullptr;
}

std::optional<cdl::Value> Arguments::value(std::string_view name) const {
  if (const cdl::Value* found = given(name)) {
    if (!std::holds_alternative<cdl::FromAbove>(*found)) return *found;
    refuse("nothing above gives a value for %" + std::string(name));
    return std::nullopt;
  }
  for (const cdl::VocabularyRow& row : cdl::parameters_of(behaviour_->name, use_)) {
    if (row.parameter != name) continue;
    if (!row.default_value.empty()) return cdl::parse_value(row.default_value);
  }
  refuse("lacks the parameter %" + std::string(name));
  return std::nullopt;
}

double Arguments::number(std::string_view name) const {
  const auto found = value(name);
  if (!found) return 0.0;
  if (const double* number = std::get_if<double>(&*found)) return *number;
  refuse("%" + std::string(name) + " is " + cdl::describe(*found) + ", wanted a number");
  return 0.0;
}

WorldVec Arguments::point(std::string_view name) const {
  const auto found = value(name);
  if (!found) return {};
  const auto* list = std::get_if<std::vector<double>>(&*found);
  // MissionLab's later versions have a height as well.
  if (list != nullptr && (list->size() == 2 || list->size() == 3)) return {(*list)[0], (*list)[1]};
  refuse("%" + std::string(name) + " is " + cdl::describe(*found) + ", wanted a point: x, y in m");
  return {};
}

std::string Arguments::word(std::string_view name) const {
  const auto found = value(name);
  if (!found) return {};
  if (const auto* words = std::get_if<cdl::Words>(&*found)) {
    if (words->words.size() == 1) return words->words.front();
  }
  if (const bool* flag = std::get_if<bool>(&*found)) return *flag ? "true" : "false";
  refuse("%" + std::string(name) + " is " + cdl::describe(*found) + ", wanted one word");
  return {};
}

Word Arguments::text(std::string_view name) const {
  const auto found = value(name);
  if (!found) return {};
  std::string text;
  if (const auto* quoted = std::get_if<cdl::QuotedText>(&*found)) {
    text = quoted->text;
  } else if (const auto* words = std::get_if<cdl::Words>(&*found); words != nullptr) {
    for (const std::string& each : words->words) text += (text.empty() ? "" : " | ") + each;
  } else {
    refuse("%" + std::string(name) + " is " + cdl::describe(*found) +
           ", wanted a text in quotation marks");
    return {};
  }
  if (Word::fits(text)) return Word(text);
  refuse("%" + std::string(name) + " is " + std::to_string(text.size()) +
         " bytes long or has letters outside ASCII, wanted at most " +
         std::to_string(Word::kMaxLength) + " printable ones");
  return {};
}

ThingSet Arguments::things(std::string_view name) const {
  const auto found = value(name);
  if (!found) return Thing::Mine;
  const auto* words = std::get_if<cdl::Words>(&*found);
  if (words == nullptr) {
    refuse("%" + std::string(name) + " is " + cdl::describe(*found) +
           ", wanted classes of things, such as Mines | Enemies");
    return Thing::Mine;
  }
  ThingSet all;
  for (const std::string& word : words->words) {
    const ThingSet things = things_called(word);
    if (things.empty()) refuse("%" + std::string(name) + ": no things are called " + quoted(word));
    all = all | things;
  }
  return all.empty() ? ThingSet(Thing::Mine) : all;
}

Tick Arguments::ticks(std::string_view name) const {
  const double ticks = std::round(number(name) / kTickS);
  if (ticks >= 0.0 && ticks < 1e12) return static_cast<Tick>(ticks);
  refuse("%" + std::string(name) + " is no time that can be waited for");
  return 0;
}

}  // namespace tacit
