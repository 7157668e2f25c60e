#pragma once
#include "roomgraph/base/Notes.h"
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

// In:   Stages, all steps done
// Out:  Notes
// Next: Stages, as more of its notes

/** What was left out of the map, and why the result is empty or lacks rooms. */
[[nodiscard]] Notes extractionNotes(const Stages& s);

}  // namespace roomgraph
