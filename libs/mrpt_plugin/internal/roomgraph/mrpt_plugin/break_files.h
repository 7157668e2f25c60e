#pragma once
#include <string>
#include <vector>

#include "roomgraph/breaks/frames_at_break.h"
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/scans/PlacedScan.h"

namespace roomgraph {

// Ours
// In:   Comparison, the maps of its runs, the scans of one of them
// Out:  what MRPT's viewers show of a break
// Next: a file

/** What a break scene shows of the run, as objects of these names. */
struct BreakPart {
  const char* name;
  mrpt::img::TColor colour;
};
constexpr BreakPart kBreakParts[] = {
    {"before", {0, 82, 155}}, {"drawn", mrptColour(ink::vermilion)}, {"untorn", {0, 130, 90}}};

/** The walls of the best other run in grey, in the frame of the site [m]; on them what the key
 *  frames before the break saw ("before"), and what those behind it saw as the run has it
 *  ("drawn") and as it would be without the break ("untorn"), with the way of the robot; their
 *  names stand above all of it. The camera looks from above, as at the whole site. `runs` are
 *  looked up by name. */
MrptScene breakScene(const Comparison& comparison, const MapBreak& tear,
                     const std::vector<Run>& runs);
/** The bytes of a `.3Dscene` file; the same comparison gives the same bytes. */
std::string breakSceneBytes(const Comparison& comparison, const MapBreak& tear,
                            const std::vector<Run>& runs);

/** The scans at a break, whose run lies at `pose` (site <- run), in the frame of the site: as the
 *  run has them, or with those behind the break where they would lie without it. `all` are those
 *  of the run. */
std::vector<PlacedScan> scansAtBreak(const MapBreak& tear, const Transform2D& pose,
                                     const std::vector<PlacedScan>& all, bool isUntorn);

/** The scans of a run that has drawn a place twice, in its frame: those of the first stretch, and
 *  behind them those of the second as the run has them, or laid on the first. */
std::vector<PlacedScan> scansAtDoubled(const DoubledPlace& place,
                                       const std::vector<PlacedScan>& all, bool isUntorn);

}  // namespace roomgraph
