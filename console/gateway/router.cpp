#include "console/gateway/router.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace tacit::gateway {
namespace {

bool is_parameter(std::string_view part) {
  return part.size() > 2 && part.front() == '{' && part.back() == '}';
}

std::optional<Request::Fields> match(const std::vector<std::string>& pattern,
                                     const std::vector<std::string>& parts) {
  if (pattern.size() != parts.size()) {
    return std::nullopt;
  }
  Request::Fields parameters;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_parameter(pattern[i]) && !parts[i].empty()) {
      parameters.emplace_back(pattern[i].substr(1, pattern[i].size() - 2), parts[i]);
    } else if (pattern[i] != parts[i]) {
      return std::nullopt;
    }
  }
  return parameters;
}

void add_once(std::vector<std::string>& words, std::string_view word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    words.emplace_back(word);
  }
}

}  // namespace

void Router::add(Method method, std::string_view pattern, AnyHandler handler, Accepts accepts) {
  const auto target = parse_target(pattern);
  if (!target) {
    throw std::invalid_argument("a route's pattern begins with a slash: " + std::string(pattern));
  }
  for (const Route& route : routes_) {
    if (route.method == method && route.pattern == target->parts) {
      throw std::invalid_argument("there is such a route already: " + std::string(pattern));
    }
  }
  routes_.push_back({method, target->parts, std::move(handler), std::move(accepts)});
}

Router::Found Router::find(Method method, const std::vector<std::string>& parts) const {
  Found found;
  for (const Route& route : routes_) {
    auto parameters = match(route.pattern, parts);
    if (!parameters) {
      continue;
    }
    if (route.method != method) {
      add_once(found.allowed, name_of(route.method));
    } else if (!found.route || parameters->size() < found.parameters.size()) {
      found.route = &route;
      found.parameters = std::move(*parameters);
    }
  }
  return found;
}

bool Router::owns(const std::vector<std::string>& parts) const {
  return std::any_of(routes_.begin(), routes_.end(), [&](const Route& route) {
    return !parts.front().empty() && route.pattern.front() == parts.front();
  });
}

std::string_view name_of(Method method) {
  switch (method) {
    case Method::Get:
      return "GET";
    case Method::Post:
      return "POST";
    case Method::Put:
      return "PUT";
    case Method::Delete:
      return "DELETE";
  }
  return "";
}

}  // namespace tacit::gateway
