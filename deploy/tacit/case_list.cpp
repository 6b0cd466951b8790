#include "deploy/tacit/case_list.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "wizard_service/cbr/features.h"

namespace tacit {
namespace {

using Json = nlohmann::ordered_json;

/// Titles need not be UTF-8.
std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string yes_or_no(bool yes) { return yes ? "yes" : "no"; }

Json to_json(const CaseFeatures& features) {
  return {{"task", cbr::word(features.task)},
          {"robots", features.robots},
          {"localization", cbr::word(features.localization)},
          {"environment", cbr::word(features.environment)},
          {"handles_enemy", features.handles_enemy}};
}

double good(const cbr::TrackRecord& record) {
  return static_cast<double>(record.good_milli) / 1000.0;
}

Json to_json(const cbr::TrackRecord& record) {
  Json failures = Json::array();
  for (const cbr::Failure& failure : record.failures) {
    failures.push_back({{"what", failure.what}, {"map", failure.map}});
  }
  return {{"uses", record.uses},
          {"outcomes", record.outcomes},
          {"good", good(record)},
          {"failures", failures}};
}

}  // namespace

std::string record_line(const cbr::TrackRecord& record) {
  std::string text;
  if (record.outcomes > 0) {
    char number[32];
    std::snprintf(number, sizeof number, "%.3g", good(record));
    text = std::string(number) + " of " + std::to_string(record.outcomes) + " good";
  }
  if (record.uses > 0) {
    text += (text.empty() ? "" : ", ") + std::to_string(record.uses) +
            (record.uses == 1 ? " use" : " uses");
  }
  return text;
}

Table case_table(std::span<const cbr::Case> cases) {
  Table table{std::to_string(cases.size()) + (cases.size() == 1 ? " case" : " cases"),
              {{"id", "id"},
               {"title", "title"},
               {"task", "task"},
               {"robots", "robots"},
               {"localization", "localization"},
               {"environment", "environment"},
               {"enemy", "enemy"},
               {"record", "record"}},
              {}};
  for (const cbr::Case& one : cases) {
    const CaseFeatures& features = one.features;
    table.rows.push_back(
        {static_cast<std::int64_t>(one.id), one.title, std::string(cbr::word(features.task)),
         static_cast<std::int64_t>(features.robots), std::string(cbr::word(features.localization)),
         std::string(cbr::word(features.environment)), yes_or_no(features.handles_enemy),
         record_line(one.record)});
  }
  return table;
}

std::string cases_json(std::span<const cbr::Case> cases) {
  Json list = Json::array();
  for (const cbr::Case& one : cases) {
    list.push_back({{"id", one.id},
                    {"title", one.title},
                    {"origin", one.origin},
                    {"features", to_json(one.features)},
                    {"record", to_json(one.record)}});
  }
  return dumped(list);
}

std::string flaws_json(std::span<const cbr::Flaw> flaws) {
  Json list = Json::array();
  for (const cbr::Flaw& flaw : flaws) {
    list.push_back({{"id", flaw.id}, {"reason", flaw.reason}});
  }
  return dumped(list);
}

std::string case_file_name(const cbr::Case& one) {
  constexpr std::size_t kLongest = 48;
  std::string name = std::to_string(one.id) + '_';
  for (const char c : one.title) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    const bool capital = c >= 'A' && c <= 'Z';
    if (plain || capital) {
      name += capital ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (name.back() != '_') {
      name += '_';
    }
    if (name.size() == kLongest) break;
  }
  return name.substr(0, name.find_last_not_of('_') + 1) + ".cdl";
}

}  // namespace tacit
