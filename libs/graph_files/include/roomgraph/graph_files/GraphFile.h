#pragma once
#include <string>
#include <variant>
#include <vector>

#include "roomgraph/base/Notes.h"
#include "roomgraph/pipeline/Stages.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

/** One option with its value, as it was when the file was written. */
struct SavedOption {
  std::string section, key;
  std::variant<double, int, bool, std::string> value;
};

/** What a roomgraph/graph file holds: the result and where it comes from. */
struct GraphFile {
  std::string program, version;  ///< that wrote it
  struct Input {
    std::string file;  ///< base name, so that the bytes do not depend on the folder
    std::string kind, sha256, insertion;  ///< as in GreyMap::Source
    GridFrame frame;
  } input;
  std::vector<SavedOption> options;  ///< all of them, in pipeline order
  /** Read from a file, the paths have no obstacles and all numbers are rounded to 0.1 mm. */
  RoomGraph graph;
  AreaGraph areas;                     ///< without labels, which are a picture of their own
  std::vector<std::string> areaNames;  ///< given by users; empty for none
  Notes notes;
};

/** What is worth saving of an extraction, by this program. */
[[nodiscard]] GraphFile graphFile(const Stages& stages);

/** The options as an ini file without comments, to be read by fromIni(). */
[[nodiscard]] std::string optionsIni(const GraphFile& file);

}  // namespace roomgraph
