#pragma once
#include "roomgraph/base/Json.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

/** Sections of keys, as in the file of a graph. */
Json optionsJson(const ExtractOptions& options);

}  // namespace roomgraph
