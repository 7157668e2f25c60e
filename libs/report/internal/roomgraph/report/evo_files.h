#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   ComparedRun
// Out:  files for evo, the tools for trajectories
// Next: a file

/** Its path in the frame of the site as the TUM benchmark writes trajectories, "time x y z qx qy qz
 *  qw", a line for each scan [s, m]. Where not every scan has a time, times are the numbers of the
 *  key frames. Empty for a run without scans. */
std::string pathTum(const ComparedRun& run);

/** A result of evo, for evo_res: how far what each scan has drawn lies from the consensus (PathPose
 *  ::error), its statistics, and where it was. `name` labels it there. Empty where the error of no
 *  scan is known. */
std::string evoResult(const ComparedRun& run, const std::string& name);

}  // namespace roomgraph
