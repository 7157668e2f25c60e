#pragma once
#include <string>

#include "roomgraph/evaluation/stability.h"

namespace roomgraph {

/** What to do with each map. */
struct StabilityTask {
  ExtractOptions extract;
  StabilityOptions options;
  std::string folder;    ///< for the results
  unsigned threads = 0;  ///< noisy maps at the same time; 0 for one per core
  bool isQuiet = false;
};

/** Does the whole experiment with one map, writes its files and prints its table. What an
 *  interrupted run of the same map and options has left in X.stability.partial.json is not computed
 *  again; that file goes once the results are written. Does not throw: returns an exit code, with
 *  one line on stderr where it is not kDone. */
int stabilityOfMap(const std::string& mapFile, const StabilityTask& task);

}  // namespace roomgraph
