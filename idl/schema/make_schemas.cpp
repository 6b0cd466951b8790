#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>

#include "idl/schema/ros2msg.h"

namespace tacit {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw IdlError(file, 0, "cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string as_source(const std::vector<IdlStruct>& structs) {
  std::string source =
      "#include \"idl/schema/schema.h\"\n\nnamespace tacit {\n\n"
      "std::span<const WireSchema> schemas() {\n"
      "  static constexpr WireSchema kSchemas[] = {\n";
  for (const IdlStruct& each : structs) {
    source += "      {\"" + ros2msg_name(each) + "\", R\"msg(" + ros2msg_text(each, structs) +
              ")msg\"},\n";
  }
  return source + "  };\n  return kSchemas;\n}\n\n}  // namespace tacit\n";
}

void make(const std::string& out, std::span<char* const> files) {
  std::vector<IdlStruct> structs;
  for (const char* file : files) {
    for (IdlStruct& each : parse_idl(text_of(file), file)) structs.push_back(std::move(each));
  }
  std::ofstream(out, std::ios::binary) << as_source(structs);
}

}  // namespace
}  // namespace tacit

/// make_schemas OUT.cpp FILE.idl...: the schemas of all structs as a C++ source.
int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: make_schemas OUT.cpp FILE.idl...\n");
    return 2;
  }
  try {
    tacit::make(argv[1], {argv + 2, static_cast<std::size_t>(argc) - 2});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
