#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/report/faults.h"
#include "roomgraph/scans/PlacedScan.h"

namespace roomgraph {

// In:   Fault, the maps of the runs, the scans of one of them
// Out:  what MRPT's viewers show of it
// Next: a file

/** What such a scene shows of the run, as objects of these names. */
struct FaultPart {
  const char* name;
  mrpt::img::TColor colour;
};
constexpr FaultPart kFaultParts[] = {
    {"before", {0, 82, 155}}, {"drawn", mrptColour(ink::vermilion)}, {"untorn", {0, 130, 90}}};

/** The walls of the best other run in grey, in the frame of the site [m]; on them what the earlier
 *  key frames saw ("before"), and what the later ones saw as the run has it ("drawn") and as it
 *  fits ("untorn"), with the way of the robot; their names stand above all of it. The camera looks
 *  from above, as at the whole site. `runs` are looked up by name. */
MrptScene faultScene(const Comparison& comparison, const Fault& fault,
                     const std::vector<Run>& runs);
/** The bytes of a `.3Dscene` file; the same comparison gives the same bytes. */
std::string faultSceneBytes(const Comparison& comparison, const Fault& fault,
                            const std::vector<Run>& runs);

/** The scans of both times, whose run lies at `pose` (the frame of the fault <- run), in the frame
 *  of the fault: as the run has them, or with the later ones where they fit. `all` are those of the
 *  run. */
std::vector<PlacedScan> scansAtFault(const Fault& fault, const Transform2D& pose,
                                     const std::vector<PlacedScan>& all, bool isUntorn);

}  // namespace roomgraph
