#include "console/gateway/static_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <system_error>

namespace tacit::gateway {
namespace fs = std::filesystem;
namespace {

struct MediaType {
  std::string_view end;
  std::string_view type;
};

constexpr std::array kMediaTypes{
    MediaType{".html", "text/html; charset=utf-8"},
    MediaType{".js", "text/javascript; charset=utf-8"},
    MediaType{".mjs", "text/javascript; charset=utf-8"},
    MediaType{".css", "text/css; charset=utf-8"},
    MediaType{".json", "application/json"},
    MediaType{".map", "application/json"},
    MediaType{".webmanifest", "application/manifest+json"},
    MediaType{".svg", "image/svg+xml"},
    MediaType{".png", "image/png"},
    MediaType{".jpg", "image/jpeg"},
    MediaType{".webp", "image/webp"},
    MediaType{".ico", "image/x-icon"},
    MediaType{".woff2", "font/woff2"},
    MediaType{".wasm", "application/wasm"},
    MediaType{".txt", "text/plain; charset=utf-8"},
    MediaType{".md", "text/plain; charset=utf-8"},
};

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

bool is_file(const fs::path& path) {
  std::error_code failed;
  return fs::is_regular_file(path, failed);
}

/// Size and time of change. Made from the file that is sent, so that each encoding has its own.
std::string etag(const fs::path& file) {
  std::error_code failed;
  const auto size = fs::file_size(file, failed);
  const auto time = fs::last_write_time(file, failed).time_since_epoch().count();
  return '"' + std::to_string(size) + '-' + std::to_string(time) +
         (file.extension() == ".gz" ? "-gz\"" : "\"");
}

/// Whether the list of tags in If-None-Match holds `tag`; a weak one counts as well.
bool matches(std::string_view list, std::string_view tag) {
  return list == "*" || list.find(tag) != std::string_view::npos;
}

/// Whether a list like "br, gzip;q=0.5" takes gzip.
bool takes_gzip(std::string_view list) {
  const std::size_t at = list.find("gzip");
  if (at == std::string_view::npos) {
    return false;
  }
  std::string_view rest = list.substr(at + 4);
  rest = rest.substr(0, rest.find(','));
  const std::size_t q = rest.find("q=");
  return q == std::string_view::npos ||
         rest.find_first_of("123456789", q) != std::string_view::npos;
}

}  // namespace

std::string_view media_type(const fs::path& file) {
  const std::string end = file.extension();
  for (const MediaType& known : kMediaTypes) {
    if (known.end == end) {
      return known.type;
    }
  }
  return "application/octet-stream";
}

StaticFiles::StaticFiles(fs::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {
  std::error_code failed;
  const fs::path real = fs::canonical(folder_, failed);
  folder_ = failed ? fs::path() : real;
}

Response StaticFiles::answer(const Request& request, const std::vector<std::string>& parts) const {
  const fs::path file = find(parts);
  if (file.empty()) {
    const bool is_page = parts.back().find('.') == std::string::npos;
    return is_page && !is_file(folder_ / "index.html")
               ? built_in_page()
               : error(404, "there is nothing at " + request.path);
  }
  Response response;
  response.content_type = media_type(file);
  response.file = file;
  fs::path packed = file;
  packed += ".gz";
  const bool has_packed = is_file(packed);
  if (has_packed) {
    response.headers.emplace_back("Vary", "Accept-Encoding");
  }
  if (has_packed && takes_gzip(request.header("accept-encoding"))) {
    response.file = packed;
    response.headers.emplace_back("Content-Encoding", "gzip");
  }
  const std::string tag = etag(response.file);
  const bool hashed = parts.front() == "assets" && file.filename() != "index.html";
  response.headers.emplace_back("ETag", tag);
  response.headers.emplace_back("Cache-Control",
                                hashed ? "public, max-age=31536000, immutable" : "no-cache");
  if (matches(request.header("if-none-match"), tag)) {
    response.status = 304;
    response.file.clear();
  }
  return response;
}

fs::path StaticFiles::find(const std::vector<std::string>& parts) const {
  if (folder_.empty()) {
    return {};
  }
  fs::path path = folder_;
  for (const std::string& part : parts) {
    if (part.starts_with('.') || part.find('/') != std::string::npos) {
      return {};
    }
    path /= part;
  }
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  const auto [in_folder, in_path] =
      std::mismatch(folder_.begin(), folder_.end(), real.begin(), real.end());
  if (!failed && in_folder == folder_.end() && is_file(real) && !parts.back().empty()) {
    return real;
  }
  const bool is_page = parts.back().find('.') == std::string::npos;
  const fs::path index = folder_ / "index.html";
  return is_page && is_file(index) ? index : fs::path();
}

Response StaticFiles::built_in_page() const {
  Response response;
  response.content_type = "text/html; charset=utf-8";
  response.headers.emplace_back("Cache-Control", "no-store");
  const std::string name = escaped(name_);
  response.body = "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>" + name +
                  "</title>\n<h1>" + name +
                  "</h1>\n<p>The pages are not installed. Requests and the WebSocket work: "
                  "Foxglove and Lichtblick connect to <code>/ws</code> here.</p>\n</html>\n";
  return response;
}

}  // namespace tacit::gateway
