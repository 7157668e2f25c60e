#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

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

}  // namespace roomgraph
