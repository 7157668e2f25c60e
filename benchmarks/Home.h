#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LabelMap.h"

namespace roomgraph {

/** A home that was drawn as text, or labels for a map of a real one. A file has one thing a line:
 *
 *    room NAME X0 Y0 X1 Y1     a box of a room's floor [m]; several make one room
 *    door X0 Y0 X1 Y1          free, in no room [m]
 *    window X0 Y0 X1 Y1        the same; a robot sees out of it
 *    thing X0 Y0 X1 Y1         furniture [m]
 *    map FILE M                of a real home: its map, below the data folder, and its cells' side
 *    outline NAME X Y X Y ...  a room of it [pixels, from the upper left corner]
 *
 *  Everything else is wall; '#' starts a comment. */
struct Home {
  struct LabelledRoom {
    std::string name;
    std::vector<Box> floor;  ///< [m]
    Ring outline;            ///< [pixels]
  };
  std::string name;
  std::vector<LabelledRoom> rooms;
  std::vector<Box> doors, windows, things;  ///< [m]
  std::string mapFile;                      ///< empty for a home that is drawn
  double resolution = 0;                    ///< of that map [m]
};

/** Throws DataError where a line says something else. */
Home readHome(const std::string& file);

/** The plan of a home that is drawn, 0.05 m a cell, without furniture or with it; with the levels
 *  of FloorPlan.h. What lies 3 m round it is open ground. */
GreyMap homePlan(const Home& home, bool isFurnished);

/** What a cleaning robot knows of the furnished home after it has been wherever it fits in. */
GreyMap robotMap(const Home& home);

/** Which room each cell of `frame` belongs to: 1 + its index; 0 for none. */
LabelMap homeTruth(const Home& home, const GridFrame& frame);

}  // namespace roomgraph
