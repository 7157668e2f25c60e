#include "roomgraph/base/utf8_text.h"

#include <nlohmann/json.hpp>

namespace roomgraph {

std::string utf8Text(const std::string& text) {
  using Json = nlohmann::json;
  const std::string json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(json).get<std::string>();
}

}  // namespace roomgraph
