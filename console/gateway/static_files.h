#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "console/gateway/http.h"

namespace tacit::gateway {

/// Files of a folder as answers.
///
/// What lies below assets/ has a name that changes with its content, and may be kept for ever; the
/// rest is asked for again with its ETag. A file NAME.gz beside a file is sent to those who take
/// gzip. Paths without a dot in their last part that are no file get index.html, so that a page
/// may have addresses of its own. Names that begin with a dot, and what links lead to outside of
/// the folder, are not there.
class StaticFiles {
 public:
  /// `name` is what the built-in page calls the server when there is no index.html.
  StaticFiles(std::filesystem::path folder, std::string name);
  /// `parts` as in Target.
  [[nodiscard]] Response answer(const Request& request,
                                const std::vector<std::string>& parts) const;

 private:
  [[nodiscard]] std::filesystem::path find(const std::vector<std::string>& parts) const;
  [[nodiscard]] Response built_in_page() const;

  std::filesystem::path folder_;
  std::string name_;
};

/// By the name's end; "application/octet-stream" for others.
[[nodiscard]] std::string_view media_type(const std::filesystem::path& file);

}  // namespace tacit::gateway
