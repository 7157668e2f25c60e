#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

struct Recording;

// In:   a map file
// Out:  the entry of its format
// Next: loadGrid

/** A kind of map file. All that knows one stands in mapFormats() and in its reader; the program's
 *  help, the names of its results and the texts of errors follow from the table. */
struct MapFormat {
  const char* kind;                      ///< as in GreyMap::source and in results
  std::vector<const char*> extensions;   ///< usual ones; files are recognised by content
  const char* name;                      ///< for people
  bool (*looksLike)(CheckedFile& file);  ///< by its first bytes
  /** Reads its grid; null where it has none, and one is made of its scans. */
  GreyMap (*readGrid)(CheckedFile& file, const LoadGridOptions& options);
  /** Reads its scans; null where it has none. One of the two is there. */
  Recording (*readRecording)(CheckedFile& file);
};

/** All of them, in the order in which they are tried. */
[[nodiscard]] const std::vector<MapFormat>& mapFormats();

/** For people: "MRPT grid map, ROS map or picture". */
[[nodiscard]] std::string mapFormatNames();
/** For people: "MRPT grid map (.gridmap), ROS map (.yaml, .yml) or picture (.png)". */
[[nodiscard]] std::string mapFormatsText();

/** The X of the results of a map: the file's name without its folder, ".gz" and then the extension
 *  of a format: "a.simplemap.gz" gives "a", "odd.name.gridmap" gives "odd.name", "scan.dat"
 *  stays. */
[[nodiscard]] std::string mapStem(const std::string& mapFile);

}  // namespace roomgraph
