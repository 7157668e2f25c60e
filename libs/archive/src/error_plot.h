#pragma once
#include <string>

#include "roomgraph/archive/export_history.h"

namespace roomgraph {

// In:   WatchedSite
// Out:  an SVG picture
// Next: historyPage

/** The map errors of a robot over time: a dot for each run that can be judged, with its interval;
 *  a cross for one that is torn, a triangle at the top for one that lies beyond; the limit, Theil
 *  and Sen's line through the window where it rises, the change where there is one, and a ring for
 *  the last good run. Empty where no run can be judged. */
std::string errorPlot(const WatchedSite& site, const RobotWatch& robot,
                      const WatchOptions& options);

/** The same in the size of a word, without axes; a dot where there is one run. */
std::string errorSparkline(const WatchedSite& site, const RobotWatch& robot,
                           const WatchOptions& options);

}  // namespace roomgraph
