#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace roomgraph {

/** Members stay in the order in which they were added. */
using Json = nlohmann::ordered_json;

/** On one line. File names need not be UTF-8; what is not gets a replacement sign. */
std::string lineOf(const Json& json);

}  // namespace roomgraph
