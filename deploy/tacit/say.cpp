#include "deploy/tacit/say.h"

#include <iostream>

namespace tacit {

void say(std::string_view text) { std::cerr << "tacit: " << text << std::endl; }

}  // namespace tacit
