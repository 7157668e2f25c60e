#pragma once
#include <string>
#include <vector>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** A kind of file that a result can be written as. */
struct OutputFormat {
  const char *name, *extension;  ///< for --format; of the file
  std::string (*bytes)(const Stages& stages);
};

/** "json, svg, ... or all", for people. */
std::string formatNames();

/** The list of those that are written where none are asked for: what shows the graph. Labels and
 *  osm, which show the areas, take time and space that most calls can do without. */
std::string defaultFormats();

/** The formats of a comma-separated list, in the order of the list, each once; "all" stands for
 *  every one. Throws UsageError for a name that is none. */
std::vector<OutputFormat> parseFormats(const std::string& list);

}  // namespace roomgraph
