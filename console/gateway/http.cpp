#include "console/gateway/http.h"

#include <atomic>
#include <nlohmann/json.hpp>

namespace tacit::gateway {
namespace {

std::string_view first_of(const Request::Fields& fields, std::string_view name) {
  for (const auto& [key, value] : fields) {
    if (key == name) {
      return value;
    }
  }
  return {};
}

}  // namespace

std::string_view Request::parameter(std::string_view name) const {
  return first_of(parameters, name);
}
std::string_view Request::in_query(std::string_view name) const { return first_of(query, name); }
std::string_view Request::header(std::string_view name) const { return first_of(headers, name); }

Response json(std::string text) {
  Response response;
  response.body = std::move(text);
  return response;
}

Response error(int status, std::string_view what, std::string_view wanted) {
  nlohmann::ordered_json body{{"error", what}};
  if (!wanted.empty()) {
    body["wanted"] = wanted;
  }
  Response response;
  response.status = status;
  response.body = body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return response;
}

class Responder::Once {
 public:
  explicit Once(std::function<void(Response)> send) : send_(std::move(send)) {}
  Once(const Once&) = delete;
  Once& operator=(const Once&) = delete;
  ~Once() {
    if (!done_) {
      send_(error(500, "the request was dropped without an answer"));
    }
  }
  void answer(Response response) {
    if (!done_.exchange(true)) {
      send_(std::move(response));
    }
  }

 private:
  std::atomic<bool> done_ = false;
  std::function<void(Response)> send_;
};

Responder::Responder(std::function<void(Response)> send)
    : once_(std::make_shared<Once>(std::move(send))) {}

void Responder::operator()(Response response) const { once_->answer(std::move(response)); }

}  // namespace tacit::gateway
