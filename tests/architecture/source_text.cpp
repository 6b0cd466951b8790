#include "tests/architecture/source_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace tacit {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool is_source(const std::filesystem::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

/// Where the token that starts at `at` and is not code ends; `at` itself when it is code.
std::size_t end_of_comment_or_literal(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) == "//") {
    return std::min(text.find('\n', at), text.size());
  }
  if (text.substr(at, 2) == "/*") {
    return std::min(text.find("*/", at + 2), text.size() - 2) + 2;
  }
  const char quote = text[at];
  // A quote behind a digit parts the digits of a number.
  const bool parts_digits = quote == '\'' && at > 0 && std::isxdigit(text[at - 1]) != 0;
  if ((quote != '"' && quote != '\'') || parts_digits) {
    return at;
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != quote && text[end] != '\n') {
    end += text[end] == '\\' ? 2 : 1;
  }
  return std::min(end + 1, text.size());
}

}  // namespace

std::vector<SourceFile> sources(const std::string& root, const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(root) / folder)) {
      if (is_source(entry.path())) {
        files.push_back({std::filesystem::relative(entry.path(), root), read(entry.path())});
      }
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::string code_only(std::string_view text) {
  std::string code;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_comment_or_literal(text, at);
    if (end == at) {
      code += text[at++];
      continue;
    }
    for (; at < end; ++at) {
      code += text[at] == '\n' ? '\n' : ' ';
    }
  }
  return code;
}

std::vector<std::string> includes(const SourceFile& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(<[^>]+>|"[^"]+"))re");
  std::vector<std::string> found;
  std::istringstream lines(file.text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) {
      found.push_back(match[1]);
    }
  }
  return found;
}

}  // namespace tacit
