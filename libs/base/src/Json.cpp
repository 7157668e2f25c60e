#include "roomgraph/base/Json.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "roomgraph/base/version.h"

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

Json numberOrNull(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return rounded(*value);
}

std::string lineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json programJson() { return {{"name", "roomgraph"}, {"version", version()}}; }

double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

void addNumber(std::string& json, double value) {
  if (!std::isfinite(value)) {
    json += "null";
    return;
  }
  char buffer[40];
  char* const end = buffer + sizeof buffer;
  if (std::abs(value) > 1e10) {  // 0.1 mm may be no whole number of 64 bits
    json.append(buffer, std::to_chars(buffer, end, value).ptr);
    return;
  }
  // Whole numbers of 0.1 mm are written several times faster than floating point ones.
  const std::int64_t all = std::llround(value * 1e4), size = std::abs(all);
  if (all < 0) json += '-';
  char* digit = std::to_chars(buffer, end, size / 10000).ptr;
  std::int64_t fraction = size % 10000;
  if (fraction > 0) *digit++ = '.';
  for (std::int64_t unit = 1000; fraction > 0; fraction %= unit, unit /= 10)
    *digit++ = char('0' + fraction / unit);
  json.append(buffer, digit);
}

}  // namespace roomgraph
