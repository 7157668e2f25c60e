#pragma once
#include <string>
#include <vector>

#include "roomgraph/relate/Run.h"
#include "roomgraph/repair/RepairedRun.h"

namespace roomgraph {

// In:   RepairedRuns, and the runs that they are of
// Out:  text of a page for a browser
// Next: a file

/** A run before and after its repair. */
struct ShownRepair {
  const Run* run = nullptr;
  const RepairedRun* repaired = nullptr;
  std::string line;  ///< what is said of it on the terminal, without its name
};

/** A page that stands alone: of each run why it was mended or not, its walls and its path before
 *  laid over those after, with an edge to be drawn from the one to the other, how far it has moved,
 *  and which steps between its key frames were breaks. O(walls). */
std::string repairPage(const std::vector<ShownRepair>& repairs);

}  // namespace roomgraph
