#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tacit::gateway {

enum class Method { Get, Post, Put, Delete };

/// What a client asks for. Text is as the client sent it, unless it says otherwise.
struct Request {
  using Fields = std::vector<std::pair<std::string, std::string>>;

  Method method = Method::Get;  ///< A HEAD request comes as Get; its answer goes without a body.
  std::string path;             ///< Decoded, begins with a slash.
  Fields parameters;            ///< What stands for `{name}` in the route's pattern, decoded.
  Fields query;                 ///< Decoded, in the order of the address.
  Fields headers;               ///< Names in lower case.
  std::string body;

  /// Each gives the first of that name, or "" when there is none.
  [[nodiscard]] std::string_view parameter(std::string_view name) const;
  [[nodiscard]] std::string_view in_query(std::string_view name) const;
  [[nodiscard]] std::string_view header(std::string_view name) const;
};

struct Response {
  int status = 200;
  std::string content_type = "application/json";
  std::string body = {};
  /// When not empty, the body is what this file holds, and `body` is ignored. It is read piece by
  /// piece while it is sent; 404 when it cannot be opened.
  std::filesystem::path file = {};
  Request::Fields headers = {};  ///< Further ones, such as Cache-Control.
};

/// 200 with a JSON text.
[[nodiscard]] Response json(std::string text);
/// `{"error": ..., "wanted": ...}`; without `wanted` when that is empty. Bytes that are no UTF-8
/// are replaced.
[[nodiscard]] Response error(int status, std::string_view what, std::string_view wanted = {});

/// Answers one request, from any thread, once; further answers are ignored. When the last copy
/// goes without an answer, the client gets 500. May outlive the server, and then does nothing.
class Responder {
 public:
  explicit Responder(std::function<void(Response)> send);
  void operator()(Response response) const;

 private:
  class Once;
  std::shared_ptr<Once> once_;
};

/// Runs on the server's thread, which serves everybody: it returns within milliseconds. What it
/// throws (std::exception) becomes a 500 with its text.
using Handler = std::function<Response(const Request&)>;
/// The same, but the answer may come later; 504 when it takes longer than Limits::answer_s.
using LaterHandler = std::function<void(Request, Responder)>;

/// What a route takes.
struct Accepts {
  /// Media types of bodies; 415 for others. A request without a body needs none.
  std::vector<std::string> types = {"application/json"};
};

}  // namespace tacit::gateway
