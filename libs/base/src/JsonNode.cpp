#include "roomgraph/base/JsonNode.h"

#include <limits>

namespace roomgraph {

JsonNode JsonNode::operator[](const char* key) const {
  if (!json.is_object()) throw Broken{place, "is not an object"};
  const auto found = json.find(key);
  if (found == json.end()) throw Broken{place, std::string("has no '") + key + "'"};
  return {*found, place.empty() ? key : place + "." + key};
}

std::vector<JsonNode> JsonNode::list() const {
  if (!json.is_array()) throw Broken{place, "is not a list"};
  std::vector<JsonNode> nodes;
  for (std::size_t i = 0; i < json.size(); ++i)
    nodes.push_back({json[i], place + "[" + std::to_string(i) + "]"});
  return nodes;
}

double JsonNode::number() const {
  if (!json.is_number()) throw Broken{place, "is not a number"};
  return json.get<double>();
}

double JsonNode::numberOrInfinity() const {
  return json.is_null() ? std::numeric_limits<double>::infinity() : number();
}

std::string JsonNode::text() const {
  if (!json.is_string()) throw Broken{place, "is not text"};
  return json.get<std::string>();
}

std::size_t JsonNode::countBelow(std::size_t end) const {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() >= end)
    throw Broken{place, "is not a whole number below " + std::to_string(end)};
  return json.get<std::size_t>();
}

void JsonNode::checkId(std::size_t expected) const {
  if ((*this)["id"].countBelow(expected + 1) != expected)
    throw Broken{place, "does not have the id " + std::to_string(expected)};
}

}  // namespace roomgraph
