#include "roomgraph/base/Json.h"

#include <cmath>

#include "roomgraph/base/rounded.h"

namespace roomgraph {

Json numberOrNull(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return rounded(*value);
}

std::string lineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace roomgraph
