#pragma once
#include <nlohmann/json.hpp>

#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

using Json = nlohmann::ordered_json;

/** Sections of keys, as in the file of a graph. */
Json optionsJson(const ExtractOptions& options);

/** On one line. File names need not be UTF-8; what is not gets a replacement sign. */
std::string lineOf(const Json& json);

}  // namespace roomgraph
