#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** What people want of the areas of a map. */
struct AreaWishes {
  std::vector<std::string> names;  ///< by AreaId; empty for none
  std::vector<RoomId> keptOut;     ///< rooms that robots must not enter
};

/** A kind of file that a result can be written as. */
struct OutputFormat {
  const char *name, *extension;  ///< for --format; of the file
  std::string (*bytes)(const Stages& stages, const AreaWishes& wishes);
  bool isDefault = true;            ///< written where nothing else is asked for
  std::optional<RosMapMode> map{};  ///< of a picture that is a ROS map, with a yaml beside it

  /** Of the yaml: "keepout.yaml" of "keepout.png". */
  std::string yamlExtension() const { return std::string(name) + ".yaml"; }
};

/** "a, b, all or c", for people, where "all" does not stand for c, one of `more`. */
std::string listedFormats(const std::vector<std::string>& known,
                          const std::vector<std::string>& more = {});

/** The names of a comma-separated list, in the order of the list, each once; "all" stands for every
 *  one of `known`, and for none of `more`. Throws UsageError for a name that is none of them. */
std::vector<std::string> chosenFormats(const std::string& list,
                                       const std::vector<std::string>& known,
                                       const std::vector<std::string>& more = {});

/** The names of all formats of a result, for people. */
std::string formatNames();

/** The list of those that are written where none are asked for: what shows the graph. Labels and
 *  osm, which show the areas, take time and space that most calls can do without. */
std::string defaultFormats();

/** The formats of a list as for chosenFormats(). */
std::vector<OutputFormat> parseFormats(const std::string& list);

}  // namespace roomgraph
