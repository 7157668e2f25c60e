#pragma once
#include "roomgraph/base/Options.h"

namespace roomgraph {

/** What makes a passage a door, and a region a room; see splitAtDoors. */
struct SplitAtDoorsOptions {
  /** A passage is a door where it is narrower than this share of the narrower of its two sides. */
  double maxRatio = 0.75;
  double maxWidth = 3.0;  ///< of a door, and of a short stretch of a corridor [m]
  /** Regions whose passage is narrower than this share of the wider one are two, door or not. */
  double narrowRatio = 0.45;
  double maxLeftoverArea = 1.1;   ///< a region with less joins a neighbour [m2]
  double minElongation = 0.75;    ///< a region that is shorter joins a neighbour
  double minRoomWidth = 0.9;      ///< of the largest disc in a room [m]
  double openRoomWidth = 1.95;    ///< the same of a room with a way out that is no door [m]
  double minWallShare = 0.4;      ///< of a region that is not half seen, beside the map's
  double minClosedShare = 0.7;    ///< the same of a room that is narrower than openRoomWidth
  double maxElongation = 3.5;     ///< of a room; what is longer is a corridor
  double maxCorridorWidth = 6.0;  ///< a wider region is a room, however long [m]
  double corridorRatio = 0.65;    ///< maxRatio between two pieces of corridor
  double corridorDoor = 1.8;      ///< maxWidth between pieces of corridor, and in a wall [m]
};
void describe(SplitAtDoorsOptions& options, FieldTable& table);

}  // namespace roomgraph
