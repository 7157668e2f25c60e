#pragma once
#include "kainjow/mustache.hpp"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** The values that the page's template asks for, all but its styles, scripts and pictures. The
 *  template escapes them. */
kainjow::mustache::data pageTables(const Comparison& comparison);

}  // namespace roomgraph
