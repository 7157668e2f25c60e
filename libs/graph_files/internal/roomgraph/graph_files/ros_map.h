#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

// In:   Grid
// Out:  the bytes of a ROS map, as map_saver writes it
// Next: writeFileAtomically, loadGrid

/** A picture of the cells, the highest row on top: occupied 0, free 254, unknown 205. loadGrid()
 *  reads the same cells from it, with the yaml or without. Same cells, same bytes. O(cells). */
std::string mapPgm(const Grid& grid);
/** The same as a PNG. */
std::string mapPng(const Grid& grid);

/** The first line of such a file: whoever finds another one there has a map that is somebody
 *  else's. */
constexpr char kRosMapMark[] = "# Written by roomgraph.";

/** How nav2 reads a picture's greys: as one of three states by map_saver's thresholds, or each as a
 *  value from white for 0 to black for 100. */
enum class RosMapMode { trinary, scale };

/** The yaml that places such a picture, by the name of its file, with thresholds for its greys;
 *  in another frame where `pose` (that frame <- frame of the map) says so, by its origin's yaw. */
std::string rosMapYaml(const GridFrame& frame, const std::string& picture,
                       const Transform2D& pose = {}, RosMapMode mode = RosMapMode::trinary);

/** A ROS map beside the session; its yaml is rosMapYaml(frame, picture, pose). Both names are those
 *  of files in the session's folder. */
struct SessionMap {
  std::string yaml, picture;
  GridFrame frame;   ///< of the picture, in the frame of its map
  Transform2D pose;  ///< site <- map
};

/** A pose file of maps, which the viewer lays on a map ("Load Pose"), and others read: the pose of
 *  the frame `name` in the frame "site" [m, rad]. */
std::string mapsPoseYaml(const Transform2D& pose, const std::string& name);

/** A session file (TOML) that shows all maps in the site's frame, each half transparent. Names have
 *  no folder, so the viewer must be started in that of the session: "maps -s FILE". As versions 1.7
 *  and later write it; those before read it, too. */
std::string mapsSession(const std::vector<SessionMap>& maps);

}  // namespace roomgraph
