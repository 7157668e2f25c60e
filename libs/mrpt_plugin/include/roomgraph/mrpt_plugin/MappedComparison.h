#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** The walls of a run. */
struct RunWalls {
  std::string run;           ///< name
  std::vector<Point> walls;  ///< the middles of its wall cells [m, frame of the run]
};

/** What a comparison of MRPT holds, without MRPT. */
struct MappedComparison {
  Comparison comparison;
  std::vector<RunWalls> walls;  ///< of its runs; those without are not drawn
};

}  // namespace roomgraph
