#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/CMapComparison.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   Comparison, the maps of its runs
// Out:  comparison.3Dscene
// Next: writeFileAtomically

/** The layers of the comparison, in the frame of the site [m]: for each run a set of objects with
 *  its name, then "rooms", "room names", "breaks" and "legend", as CMapComparison draws them. The
 *  camera looks from above and is turned so that the site stands upright, as in the report. `runs`
 *  are looked up by name: a run whose map is not among them is not drawn. O(cells). */
[[nodiscard]] MrptScene comparisonScene(const Comparison& comparison, const std::vector<Run>& runs);

/** The bytes of a `.3Dscene` file; the same comparison gives the same bytes. */
[[nodiscard]] std::string comparisonSceneBytes(const Comparison& comparison,
                                               const std::vector<Run>& runs);

}  // namespace roomgraph
