#pragma once
#include "roomgraph/base/Json.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** The values that the page's template asks for, all but its styles, scripts and pictures: texts,
 *  flags, and lists of rows. The template escapes them. */
Json pageTables(const Comparison& comparison);

}  // namespace roomgraph
