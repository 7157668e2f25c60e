#pragma once
#include <vector>

#include "roomgraph/compare/PreparedRun.h"
#include "roomgraph/compare/wall_distances.h"
#include "roomgraph/geometry/Transform2D.h"

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
