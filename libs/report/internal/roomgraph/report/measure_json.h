#pragma once
#include "roomgraph/base/Json.h"
#include "roomgraph/measures/Measure.h"

namespace roomgraph {

/** A figure as all files hold it, under its name. */
Json measureJson(const Measure& measure);

}  // namespace roomgraph
