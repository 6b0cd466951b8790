#include "console/gateway/desk.h"

#include <algorithm>
#include <exception>

namespace tacit::gateway {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) {
    list += (list.empty() ? "" : ", ") + word;
  }
  return list;
}

bool takes(const Accepts& accepts, const Request& request) {
  std::string_view type = request.header("content-type");
  type = type.substr(0, type.find_first_of("; "));
  return request.body.empty() ||
         std::find(accepts.types.begin(), accepts.types.end(), type) != accepts.types.end();
}

std::optional<Response> handled(const AnyHandler& handler, const Request& request,
                                const std::function<Responder()>& later) {
  try {
    if (const auto* now = std::get_if<Handler>(&handler)) {
      return (*now)(request);
    }
    std::get<LaterHandler>(handler)(request, later());
    return std::nullopt;
  } catch (const std::exception& failure) {
    return error(500, failure.what());
  }
}

}  // namespace

Desk::Desk(const ServerConfig& config)
    : guard_({config.address, config.token, config.hosts, config.origins}),
      files_(config.pages, config.name) {}

std::optional<Response> Desk::refusal(const Request& request, bool changes) const {
  const std::string_view host = request.header("host");
  if (!guard_.knows_host(host)) {
    return error(403, "this server is not called " + std::string(host),
                 "the Host localhost, or the address it is bound to");
  }
  if (changes && !guard_.lets_in(request.header("origin"), host)) {
    return error(403, "pages of other servers may not do this", "an Origin of this server");
  }
  if (!guard_.is_authorized(request)) {
    Response response = error(401, "the token is missing or wrong", "Authorization: Bearer TOKEN");
    response.headers.emplace_back("WWW-Authenticate", "Bearer");
    return response;
  }
  return std::nullopt;
}

std::optional<Response> Desk::answer(const Request& request, std::string_view raw_target,
                                     const std::function<Responder()>& later) const {
  const auto target = parse_target(raw_target);
  if (!target) {
    return error(400, "the address cannot be read");
  }
  Router::Found found = router_.find(request.method, target->parts);
  if (found.route) {
    if (!takes(found.route->accepts, request)) {
      return error(415, "a body of this type is not taken here",
                   joined(found.route->accepts.types));
    }
    Request routed = request;
    routed.parameters = std::move(found.parameters);
    return handled(found.route->handler, routed, later);
  }
  if (!found.allowed.empty()) {
    return not_allowed(found.allowed);
  }
  return from_files(request, *target, raw_target);
}

Response Desk::from_files(const Request& request, const Target& target,
                          std::string_view raw_target) const {
  if (router_.owns(target.parts)) {
    return error(404, "there is nothing at " + request.path);
  }
  if (target.parts.front() == "ws" && target.parts.size() <= 2) {
    Response response = error(426, "this is a WebSocket", "an upgrade");
    response.headers.emplace_back("Upgrade", "websocket");
    return response;
  }
  if (request.method != Method::Get) {
    return not_allowed({"GET"});
  }
  if (guard_.has_token_in_query(request)) {
    // On to the same page without the token, which then stands in no history.
    const std::string_view path = raw_target.substr(0, raw_target.find('?'));
    Response response;
    response.status = 303;
    response.content_type = "text/plain; charset=utf-8";
    response.headers.emplace_back("Location", path.starts_with("//") ? "/" : std::string(path));
    response.headers.emplace_back("Set-Cookie", guard_.cookie());
    return response;
  }
  return files_.answer(request, target.parts);
}

Response not_allowed(const std::vector<std::string>& allowed) {
  Response response = error(405, "the method is not for this address", joined(allowed));
  response.headers.emplace_back("Allow", joined(allowed));
  return response;
}

}  // namespace tacit::gateway
