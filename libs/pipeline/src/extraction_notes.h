#pragma once
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

// Ours
// In:   Stages, once all of them are made
// Out:  Notes

/** What was left out of the map, and why the result is empty or lacks rooms. */
Notes extractionNotes(const Stages& s);

}  // namespace roomgraph
