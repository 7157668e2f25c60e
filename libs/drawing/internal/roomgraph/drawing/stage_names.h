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

/** What people call a stage. */
struct StageName {
  const char* name;   ///< as in the names of files
  const char* paper;  ///< section
  const char* title;
};

/** In the order of ShownStage. */
const std::vector<StageName>& stageNames();

/** Per Voronoi edge, whether it is there before anything is left out; then without what lies
 *  outside; then without what is too near to an obstacle. */
std::vector<bool> finiteEdges(const Stages& stages);
std::vector<bool> insideEdges(const Stages& stages);
std::vector<bool> clearEdges(const Stages& stages);

/** Where the paths cross the rooms: the ends of the stretches inside of each path [m]. */
std::vector<Point> crossings(const Stages& stages);

}  // namespace roomgraph
