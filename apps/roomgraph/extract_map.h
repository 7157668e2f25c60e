#pragma once
#include <functional>
#include <string>
#include <vector>

#include "option_arguments.h"
#include "output_formats.h"
#include "roomgraph/pipeline/ExtractOptions.h"
#include "run_in_order.h"

namespace roomgraph {

/** What to do with each map. */
struct ExtractTask {
  ExtractOptions options;
  std::vector<OutputFormat> formats;
  std::vector<RoomId> keptOut;  ///< of the format keepout
  std::string folder;           ///< for the results
  std::string stagesFolder;     ///< for the pictures of the steps; empty for none
  RunningArguments running;
};

/** How often extractMap() calls `stepDone`. */
std::size_t stepCount(const ExtractTask& task);

/** Reads one map, extracts its graph, and writes all files, or none of them where the map or a
 *  drawing fails. Does not throw: a failure is one line of the report. */
JobReport extractMap(const std::string& mapFile, const ExtractTask& task,
                     const std::function<void()>& stepDone);

}  // namespace roomgraph
