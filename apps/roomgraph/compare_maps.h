#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/ledger/SiteFile.h"
#include "roomgraph/pipeline/ExtractOptions.h"
#include "roomgraph/relate/estimate_scale.h"

namespace roomgraph {

/** What to compare, and how. */
struct CompareTask {
  ExtractOptions extract;
  CompareRunsOptions options;
  std::vector<std::string> files;  ///< of the runs
  std::string reference;           ///< file; empty for none
  std::string names;            ///< file of the site's rooms, made if it is not there; empty: none
  std::string cache;            ///< folder that keeps pairs from call to call; empty: none
  bool isAligned = false;       ///< all maps are in one frame already
  bool estimatesScale = false;  ///< of bare pictures
  EstimateScaleOptions scale;   ///< how that is done
  unsigned threads = 0;         ///< 0 for one per core
  bool isQuiet = false;
};

struct ComparedMaps {
  Comparison comparison;
  std::vector<PreparedRun> runs;  ///< all that could be read, for pictures
  std::optional<SiteFile> site;   ///< what CompareTask::names is to hold now
  int exitCode = 0;               ///< not kDone where a file could not be used
};

/** Reads all maps, aligns all pairs and compares the runs. A map that cannot be read, or has no
 *  walls, is one line on stderr and left out. Where scales are to be estimated, each bare picture
 * is read at the scale at which it fits the maps that have one (the reference alone, if it has
 * one); where there is none, it is left out as of another site. The same numbers for any order of
 * the files and any number of threads.
 *  @throws DataError where no map at all, the reference or the file of names cannot be used, or no
 *  map tells the scale.
 *  @throws UsageError where scales are to be estimated and no map is a bare picture. */
ComparedMaps compareMaps(const CompareTask& task);

}  // namespace roomgraph
