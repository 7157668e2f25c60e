#pragma once
#include <vector>

#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {

/** What all runs of a site agree on, by run. Copies of one map have the same. */
struct Consensus {
  std::vector<RunSubmaps> submaps;
  SubmapPoses poses;             ///< where the submaps really lie, in a frame of its own
  std::vector<MapError> errors;  ///< of each run
};

}  // namespace roomgraph
