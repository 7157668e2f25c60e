#include "roomgraph/base/Json.h"

namespace roomgraph {

std::string lineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace roomgraph
