#pragma once
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** What an error of a key frame [m] looks like: from green over yellow to red, which it is from
 *  kWorstError on; blue where it cannot be told. */
mrpt::img::TColor colourOfError(const std::optional<double>& error);
constexpr double kWorstError = 0.5;

/** The way of the robot by the error of what was drawn from it, with a dot for each key frame. */
viz::CSetOfObjects::Ptr drawPath(const std::vector<PathPose>& path);

}  // namespace roomgraph
