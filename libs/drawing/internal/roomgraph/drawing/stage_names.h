#pragma once
#include <vector>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** The stages of an extraction that can be shown, in the order of the pipeline. */
enum class ShownStage {
  grid,
  obstacles,
  voronoi,
  inside,
  clear,
  topology,
  pruned,
  joined,
  largest,
  rooms,
  borderVertices,
  cut,
  cleaned,
  doors,
  result,
  areas
};

/** What people call a stage, and what it shows. */
struct StageName {
  const char* name;   ///< as in the names of files
  const char* paper;  ///< section
  const char* title;
  TopologyGraph Stages::*graph = nullptr;  ///< that it has made; from `cut` on, with the rooms
  /** Whether each edge of the Voronoi diagram is still there; null where it is not shown. */
  std::vector<bool> (*edges)(const Stages& stages) = nullptr;
};

/** In the order of ShownStage. */
const std::vector<StageName>& stageNames();

/** Where the paths cross the rooms: the ends of the stretches inside of each path [m]. */
std::vector<Point> crossings(const Stages& stages);

}  // namespace roomgraph
