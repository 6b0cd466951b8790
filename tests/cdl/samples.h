#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace tacit::cdl {

/// One of the missions of our own, by its file name.
inline std::string own_sample(const std::string& name) {
  std::ifstream in(TACIT_SOURCE_DIR "/tests/fuzz/cdl_corpus/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A mission of one robot with the automaton of these items.
inline std::string with_automaton(const std::string& items) {
  return "[\nvehicle(bound_to = r:MRV2([movement(bound_to = base:DRIVE(\nv = FSA(\n" + items +
         "\n)))]))\n]";
}

}  // namespace tacit::cdl
