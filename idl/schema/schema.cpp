#include "idl/schema/schema.h"

namespace tacit {

std::string_view ros2msg_schema(std::string_view type) {
  for (const WireSchema& schema : schemas()) {
    if (schema.name == type) return schema.text;
  }
  return {};
}

}  // namespace tacit
