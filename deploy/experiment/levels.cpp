#include "deploy/experiment/levels.h"

#include <algorithm>
#include <string_view>

#include "idl/types/config_error.h"

namespace tacit {
namespace {

constexpr std::string_view kBlank = " \t";
constexpr const char* kVariantForm = "name: section.key = value; section.key = value";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

/// The trimmed parts of `text` between the characters `by`; of an empty text one empty part.
std::vector<std::string> parted(std::string_view text, char by) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find(by, start), text.size());
    parts.push_back(trimmed(text.substr(start, end - start)));
    start = end + 1;
  }
  return parts;
}

Setting split(const std::string& text, const char* form) {
  const std::size_t equals = text.find('=');
  const std::string path = trimmed(std::string_view(text).substr(0, equals));
  const std::string value =
      equals == std::string::npos ? "" : trimmed(std::string_view(text).substr(equals + 1));
  if (path.find('.') == std::string::npos || value.empty()) {
    throw ConfigError("[experiment] found \"" + text + "\", wanted \"" + form + '"');
  }
  return {path, value};
}

}  // namespace

Setting read_setting(const std::string& text) { return split(text, "section.key = value"); }

Factor read_factor(const std::string& text) {
  const Setting whole = split(text, "section.key = value, value, …");
  Factor factor{whole.path, parted(whole.value, ',')};
  for (const std::string& value : factor.values) {
    if (value.empty()) {
      throw ConfigError("[experiment] factor \"" + text +
                        "\" has an empty value, wanted \"section.key = value, value, …\"");
    }
  }
  return factor;
}

Variant read_variant(const std::string& text) {
  const std::size_t colon = text.find(':');
  Variant variant{trimmed(std::string_view(text).substr(0, colon)), {}};
  if (colon == std::string::npos || variant.name.empty() ||
      variant.name.find('=') != std::string::npos) {
    throw ConfigError("[experiment] found \"" + text + "\", which has no name, wanted \"" +
                      kVariantForm + '"');
  }
  for (const std::string& part : parted(std::string_view(text).substr(colon + 1), ';')) {
    variant.settings.push_back(split(part, kVariantForm));
  }
  return variant;
}

}  // namespace tacit
