#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

// Ours
// In:   the frames of several maps, and where these lie in one site
// Out:  the texts of files for another viewer, called maps
// Next: StagedFiles

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
