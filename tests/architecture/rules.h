#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_text.h"

namespace tacit {

/// Each finding names the file and what stands in it that must not. Empty when all is well.
using Findings = std::vector<std::string>;

/// What only impure code may use: system headers outside the short list that pure code needs, and
/// names whose result differs between runs or machines.
[[nodiscard]] Findings impurities(const std::vector<SourceFile>& files);

/// Headers that only some files may include: Bullet, Fast DDS, toml++.
[[nodiscard]] Findings misplaced_middleware(const std::vector<SourceFile>& files);

/// Includes that are not written from the root.
[[nodiscard]] Findings relative_includes(const std::vector<SourceFile>& files);

/// What each target links, by name.
using LinkGraph = std::map<std::string, std::set<std::string>>;

/// Reads lines of "target: linked linked ...".
[[nodiscard]] LinkGraph parse_link_graph(const std::string& text);

/// Links of the graph that the table of docs/architecture.md does not have, and libraries that
/// the table does not know.
[[nodiscard]] Findings forbidden_links(const LinkGraph& graph);

}  // namespace tacit
