#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   Comparison, the maps of its runs
// Out:  comparison.3Dscene
// Next: writeFileAtomically

/** The runs laid on each other, in the frame of the site [m]. For each run a set of objects with
 *  its name and its pose holds the middles of its wall cells, in the colour that it has in the
 *  report, the best on top, a few centimetres apart. Then "rooms" (outlines), "room names" and
 *  "breaks" (rings in the colour of the run, with its name and key frame), where there are any, and
 *  "legend" (the names of the runs in their colours). The camera looks from above.
 *  `runs` are looked up by name: a run whose map is not among them is not drawn. O(cells). */
MrptScene comparisonScene(const Comparison& comparison, const std::vector<Run>& runs);

/** The bytes of a `.3Dscene` file; the same comparison gives the same bytes. */
std::string comparisonSceneBytes(const Comparison& comparison, const std::vector<Run>& runs);

}  // namespace roomgraph
