#include "tests/architecture/rules.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace tacit {
namespace {

/// Headers whose contents depend on their arguments alone.
const std::set<std::string> kPureHeaders{
    // clang-format off
    "<Eigen/Core>", "<algorithm>", "<array>", "<bit>", "<cassert>", "<cctype>", "<charconv>", "<cmath>",
    "<compare>", "<concepts>", "<cstddef>", "<cstdint>", "<cstdio>", "<cstdlib>", "<cstring>",
    "<functional>", "<iterator>", "<limits>", "<map>", "<memory>", "<numeric>", "<optional>",
    "<queue>", "<set>", "<span>", "<stdexcept>", "<string>", "<string_view>", "<system_error>",
    "<tuple>", "<type_traits>", "<utility>", "<variant>", "<vector>"
    // clang-format on
};

/// Patterns of names that pure code does without, and why.
struct Ban {
  std::regex pattern;
  std::string why;
};

const std::vector<Ban>& bans() {
  static const std::vector<Ban> kBans{
      {std::regex(R"(\bstd::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|pow|)"
                  R"(log|log2|log10|log1p|hypot|cbrt|erf|erfc|tgamma|lgamma|fma)\b)"),
       "its bits differ between machines"},
      {std::regex(R"((^|[^\w.:>])(sin|cos|tan|atan|atan2|exp|pow|log|hypot|fma)\s*\()"),
       "its bits differ between machines"},
      {std::regex(R"(\bstd::(rand|srand|random_device|mt19937\w*|\w+_distribution)\b)"),
       "chance comes from a Stream"},
      {std::regex(R"((^|[^\w.:>])(rand|srand|drand48|getentropy)\s*\()"),
       "chance comes from a Stream"},
      {std::regex(R"(\bstd::(chrono|this_thread|thread|jthread|mutex|atomic\w*|async|future|)"
                  R"(condition_variable)\b|\bthread_local\b)"),
       "pure code knows neither time nor threads"},
      {std::regex(R"((^|[^\w.:>])(time|clock|gettimeofday|clock_gettime|getenv|system)\s*\()"),
       "pure code knows neither time nor environment"},
      {std::regex(R"(\bstd::(cout|cerr|clog|cin|getenv|\w*fstream|filesystem|v?f?printf|fopen)\b|)"
                  R"((^|[^\w.:>])(f?printf|puts|fopen|fputs)\s*\(|\bspdlog::)"),
       "pure code neither reads, writes nor logs"},
      {std::regex(R"(\bstd::unordered_\w+)"), "its order differs between libraries"},
      {std::regex(R"(\bstd::(set|map|multiset|multimap)<[^,>]*\*)"),
       "the order of pointers differs between runs"},
  };
  return kBans;
}

std::string number_of_line(const std::string& text, std::size_t at) {
  const auto here = text.begin() + static_cast<std::ptrdiff_t>(at);
  return std::to_string(1 + std::count(text.begin(), here, '\n'));
}

/// Bullet, PEGTL and JSON count as pure here; another rule holds them in their places.
bool is_pure(const std::string& header) {
  return kPureHeaders.contains(header) || header.starts_with("<bt") ||
         header.starts_with("<boost/math/") || header.starts_with("<tao/pegtl") ||
         header == "<nlohmann/json.hpp>";
}

/// A family of headers and the one place for them.
struct Place {
  std::regex header;
  std::regex files;
  std::string name;
};

const std::vector<Place>& places() {
  static const std::vector<Place> kPlaces{
      {std::regex(R"(<(bt[A-Z]|Bullet|LinearMath).*)"),
       std::regex(R"(world_server/world/physics\w*\.cpp|tests/.*)"), "Bullet"},
      {std::regex(R"([<"](fastdds|fastrtps|fastcdr|idl/wire)/.*)"),
       std::regex(R"(idl/bus/\w+\.(cpp|h)|tests/.*)"), "Fast DDS"},
      {std::regex(R"(<toml\+\+/.*)"), std::regex(R"(idl/scenario/document\.cpp)"), "toml++"},
      {std::regex(R"(<tao/pegtl.*)"), std::regex(R"(idl/cdl/.*)"), "PEGTL"},
      {std::regex(R"(<SQLiteCpp/.*|<sqlite3.*|<openssl/.*)"),
       std::regex(R"(console/record/.*|wizard_service/cases/case_(file|row|base)\.\w+|)"
                  R"(idl/scenario/digest\.cpp|tests/.*)"),
       "storage"},
      {std::regex(R"(<zstd\.h>|<boost/crc\.hpp>)"), std::regex(R"(console/mcap/.*)"), "MCAP"},
      {std::regex(R"(<nlohmann/.*)"),
       std::regex(R"(robot_agent/brain/learning/policy_text\.cpp|console/record/.*|)"
                  R"(console/(gateway|live|server)/.*|wizard_service/client/plan_json\.cpp|)"
                  R"(deploy/tacit/.*|tests/.*)"),
       "JSON"},
      {std::regex(R"(<boost/(asio|beast|system)\W.*)"),
       std::regex(R"(console/gateway/.*|tests/.*)"), "Boost.Beast"},
      {std::regex(R"(<boost/process.*)"), std::regex(R"(console/server/job\.cpp)"),
       "Boost.Process"},
      {std::regex(R"(<prometheus/.*)"), std::regex(R"(console/server/api_health\.cpp)"),
       "prometheus-cpp"},
  };
  return kPlaces;
}

/// Who may link whom; libraries of others count as well as our own.
const LinkGraph& table() {
  static const LinkGraph kTable{
      {"types", {"Eigen3::Eigen"}},
      {"cdl", {"types", "taocpp::pegtl"}},
      {"scenario", {"types", "tomlplusplus::tomlplusplus", "OpenSSL::Crypto"}},
      {"overlay", {"types"}},
      {"version", {}},
      {"topics", {"types"}},
      {"wire", {"fastrtps", "fastcdr"}},
      {"schema_text", {}},
      {"make_schemas", {"schema_text"}},
      {"schema", {"topics"}},
      {"bus", {"types", "topics", "wire", "Threads::Threads", "spdlog::spdlog"}},
      {"brain", {"types", "cdl", "nlohmann_json::nlohmann_json"}},
      {"world", {"types", "overlay", "PkgConfig::BULLET"}},
      {"world_map", {"scenario", "overlay", "world"}},
      {"metrics", {"types"}},
      {"debrief", {"types", "overlay"}},
      {"mcap", {"Boost::headers", "zstd::libzstd_shared"}},
      {"record",
       {"types", "metrics", "OpenSSL::Crypto", "SQLiteCpp", "nlohmann_json::nlohmann_json"}},
      {"tape", {"types", "topics", "schema", "bus", "scenario", "mcap", "record"}},
      {"report", {"types", "metrics", "Boost::headers", "nlohmann_json::nlohmann_json"}},
      {"gateway", {"Threads::Threads", "Boost::headers", "nlohmann_json::nlohmann_json"}},
      {"cbr", {"types", "cdl", "overlay"}},
      {"cases", {"types", "cbr", "SQLiteCpp"}},
      {"wizard", {"types", "topics", "bus", "overlay", "cbr", "cases", "spdlog::spdlog"}},
      {"wizard_service",
       {"wizard", "types", "topics", "bus", "cases", "version", "CLI11::CLI11", "spdlog::spdlog"}},
      {"wizard_client", {"types", "topics", "bus", "cbr", "nlohmann_json::nlohmann_json"}},
      {"live",
       {"types", "topics", "bus", "schema", "gateway", "mcap", "nlohmann_json::nlohmann_json"}},
      {"console_server",
       {"types", "topics", "bus", "gateway", "live", "mcap", "record", "wizard_client", "cbr",
        "scenario", "version", "prometheus-cpp::core", "Boost::headers",
        "nlohmann_json::nlohmann_json", "spdlog::spdlog", "Threads::Threads"}},
      {"lockstep",
       {"types", "scenario", "brain", "world", "world_map", "cdl", "overlay", "metrics"}},
      {"experiment",
       {"types", "lockstep", "report", "record", "scenario", "debrief", "overlay", "cbr",
        "Threads::Threads"}},
      {"tacit",
       {"lockstep", "experiment", "record", "report", "tape", "metrics", "debrief", "bus",
        "scenario", "cdl", "overlay", "cases", "cbr", "wizard_client", "version", "CLI11::CLI11",
        "nlohmann_json::nlohmann_json"}},
      {"server",
       {"world", "world_map", "types", "bus", "topics", "scenario", "version", "spdlog::spdlog"}},
      {"world_server",
       {"server", "world", "types", "bus", "topics", "version", "CLI11::CLI11", "spdlog::spdlog"}},
      {"agent", {"brain", "types", "bus", "topics", "scenario", "version", "spdlog::spdlog"}},
      {"robot_agent",
       {"agent", "brain", "types", "bus", "topics", "version", "CLI11::CLI11", "spdlog::spdlog"}},
      {"console",
       {"console_server", "gateway", "metrics", "record", "report", "tape", "types", "bus",
        "topics", "scenario", "version", "CLI11::CLI11", "spdlog::spdlog"}},
  };
  return kTable;
}

}  // namespace

Findings impurities(const std::vector<SourceFile>& files) {
  Findings findings;
  for (const SourceFile& file : files) {
    for (const std::string& header : includes(file)) {
      if (header.front() == '<' && !is_pure(header)) {
        findings.push_back(file.path + ": pure code includes " + header);
      }
    }
    const std::string code = code_only(file.text);
    for (const Ban& ban : bans()) {
      for (std::sregex_iterator hit(code.begin(), code.end(), ban.pattern), end; hit != end;
           ++hit) {
        const auto at = static_cast<std::size_t>(hit->position());
        findings.push_back(file.path + ':' + number_of_line(code, at) + ": " + hit->str() + ": " +
                           ban.why);
      }
    }
  }
  return findings;
}

Findings misplaced_middleware(const std::vector<SourceFile>& files) {
  Findings findings;
  for (const SourceFile& file : files) {
    for (const std::string& header : includes(file)) {
      for (const Place& place : places()) {
        if (std::regex_match(header, place.header) && !std::regex_match(file.path, place.files)) {
          findings.push_back(file.path + ": " + place.name + " has no place here: " + header);
        }
      }
    }
  }
  return findings;
}

Findings relative_includes(const std::vector<SourceFile>& files) {
  Findings findings;
  for (const SourceFile& file : files) {
    for (const std::string& header : includes(file)) {
      if (header.front() == '"' &&
          (header.starts_with("\".") || header.find('/') == std::string::npos)) {
        findings.push_back(file.path + ": not written from the root: " + header);
      }
    }
  }
  return findings;
}

LinkGraph parse_link_graph(const std::string& text) {
  LinkGraph graph;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    std::istringstream words(colon == std::string::npos ? "" : line.substr(colon + 1));
    std::set<std::string>& linked = graph[line.substr(0, line.find(':'))];
    for (std::string word; words >> word;) {
      linked.insert(word);
    }
  }
  return graph;
}

Findings forbidden_links(const LinkGraph& graph) {
  Findings findings;
  for (const auto& [target, linked] : graph) {
    const auto row = table().find(target);
    if (row == table().end()) {
      findings.push_back(target + ": not in the table of who may use whom");
      continue;
    }
    for (const std::string& library : linked) {
      if (!row->second.contains(library)) {
        findings.push_back(target + ": may not use " + library);
      }
    }
  }
  return findings;
}

}  // namespace tacit
