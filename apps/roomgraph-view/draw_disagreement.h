#pragma once
#include "View.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** Where the runs disagree, as the heat map of the report has it: a square for each cell, pale to
 *  dark by the share of the runs that see it otherwise than the others. O(runs * cells). */
viz::CSetOfObjects::Ptr drawDisagreement(const View& view);

}  // namespace roomgraph
