#pragma once
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/PreparedRun.h"
#include "roomgraph/relate/wall_distances.h"

namespace roomgraph {

/** The runs of a site in one frame. */
struct PlacedRuns {
  std::vector<const PreparedRun*> runs;
  std::vector<Transform2D> poses;  ///< site <- run
  std::vector<double> trust;       ///< of each run as an other, 0 to 1
  /** [i][j]: the walls of i against those of j. */
  std::vector<std::vector<WallDistances>> distances;
};

}  // namespace roomgraph
