#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tacit {

/// A source file of the tree.
struct SourceFile {
  std::string path;  ///< From the root: "world_server/world/world.cpp".
  std::string text;
};

/// The headers and sources below the folders `folders` of `root`, sorted by path.
[[nodiscard]] std::vector<SourceFile> sources(const std::string& root,
                                              const std::vector<std::string>& folders);

/// `text` with comments, string and character literals blanked out; lines stay where they are.
[[nodiscard]] std::string code_only(std::string_view text);

/// What the file includes, as written: "<vector>", "\"idl/types/ids.h\"".
[[nodiscard]] std::vector<std::string> includes(const SourceFile& file);

}  // namespace tacit
