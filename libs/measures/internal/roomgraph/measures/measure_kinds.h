#pragma once
#include <string>
#include <vector>

#include "roomgraph/measures/MeasureKind.h"

namespace roomgraph {

/** Those of a run, in the order of all tables. */
const std::vector<MeasureKind>& runMeasureKinds();

/** Of a run or a pair; null for none of this name. */
const MeasureKind* findMeasureKind(const std::string& name);

}  // namespace roomgraph
