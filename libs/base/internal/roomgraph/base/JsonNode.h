#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/Ids.h"
#include "roomgraph/base/Json.h"

namespace roomgraph {

/** What is wrong with a file, found anywhere below its top; says where and what. */
struct Broken {
  std::string where, problem;
};

/** A value of a file and its place in it, for messages. All but contains() throw Broken where the
 *  value is not what is asked for. */
struct JsonNode {
  const Json& json;
  std::string place;

  JsonNode operator[](const char* key) const;
  bool contains(const char* key) const { return json.contains(key); }
  std::vector<JsonNode> list() const;
  double number() const;
  /** Null stands for a number that is not finite: nothing bounds it. */
  double numberOrInfinity() const;
  std::string text() const;
  std::size_t countBelow(std::size_t end) const;
  /** Each thing carries its place in the list as its id. */
  void checkId(std::size_t expected) const;
};

/** The place in a list of `size` things. */
template <class ThingId>
ThingId readId(const JsonNode& node, std::size_t size) {
  return ThingId(node.countBelow(size));
}

template <class ThingId>
ThingId readIdOrNone(const JsonNode& node, std::size_t size) {
  return node.json.is_null() ? ThingId::none() : readId<ThingId>(node, size);
}

}  // namespace roomgraph
