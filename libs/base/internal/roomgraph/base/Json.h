#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace roomgraph {

/** Members stay in the order in which they were added. */
using Json = nlohmann::ordered_json;

/** As files hold it, see rounded(); null where there is none, or it is not finite. */
Json numberOrNull(std::optional<double> value);

/** On one line. File names need not be UTF-8; what is not gets a replacement sign. */
std::string lineOf(const Json& json);

}  // namespace roomgraph
