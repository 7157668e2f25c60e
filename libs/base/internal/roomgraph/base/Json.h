#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/Ids.h"

namespace roomgraph {

/** Members stay in the order in which they were added. */
using Json = nlohmann::ordered_json;

/** As files hold it, see rounded(); null where there is none, or it is not finite. */
Json numberOrNull(std::optional<double> value);

/** In full; null where there is none. */
template <class Value>
Json orNull(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/** On one line. File names need not be UTF-8; what is not gets a replacement sign. */
std::string lineOf(const Json& json);

/** Metres (or m2) as files hold them: rounded to 0.1 mm, never "-0". Files hold no more than that,
 *  so that reading and writing again gives the same bytes. */
double rounded(double value);

/** A coordinate as JSON text, rounded as files hold it. Most of a file is coordinates, and text
 *  written at once takes a fraction of the time of a tree of values. null where not finite. */
void addNumber(std::string& json, double value);

/** This program, as files name what made them. */
Json programJson();

/** A file of JSON with a line for each of its members, and for each entry of its lists. The text of
 *  a large map is not copied around. */
class JsonDocument {
 public:
  /** In version 1 of this format, such as "roomgraph/graph", by a program; null for none. */
  explicit JsonDocument(const std::string& format, const Json& program = programJson())
      : text_("{\n\"format\": \"" + format + "\",\n\"version\": 1") {
    if (!program.is_null()) add("program", program);
  }

  void add(const char* name, const Json& value) { addText(name, lineOf(value)); }
  /** A member whose value is JSON already. */
  void addText(const char* name, const std::string& json) {
    text_.append(",\n\"").append(name).append("\": ").append(json);
  }
  /** A list of `count` entries; `entryText` gives the JSON of each by its place. */
  template <class EntryText>
  void addEntries(const char* name, std::size_t count, const EntryText& entryText) {
    addText(name, "[");
    for (std::size_t i = 0; i < count; ++i) text_.append(i ? ",\n" : "\n").append(entryText(i));
    text_ += count > 0 ? "\n]" : "]";
  }
  template <class Things, class ToJson>
  void addList(const char* name, const Things& things, const ToJson& toJson) {
    addEntries(name, things.size(), [&](std::size_t i) { return lineOf(toJson(things[i])); });
  }
  std::string text() && { return std::move(text_ += "\n}\n"); }

 private:
  std::string text_;
};

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
