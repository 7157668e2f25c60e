#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

/** What to compare, and how. */
struct CompareTask {
  ExtractOptions extract;
  CompareRunsOptions options;
  std::vector<std::string> files;  ///< of the runs
  std::string reference;           ///< file; empty for none
  bool isAligned = false;          ///< all maps are in one frame already
  unsigned threads = 0;            ///< 0 for one per core
  bool isQuiet = false;
};

struct ComparedMaps {
  Comparison comparison;
  std::vector<PreparedRun> runs;  ///< all that could be read, for pictures
  int exitCode = 0;               ///< not kDone where a file could not be used
};

/** Reads all maps, aligns all pairs and compares the runs. A map that cannot be read, or has no
 *  walls, is one line on stderr and left out. The same numbers for any order of the files and any
 *  number of threads.
 *  @throws DataError where the reference cannot be used. */
ComparedMaps compareMaps(const CompareTask& task);

}  // namespace roomgraph
