#pragma once
#include <string>
#include <vector>

#include "MapText.h"

namespace roomgraph::test {

/** Another way to lay down, to frame and to sample the same drawing. */
struct Pose {
  bool isTransposed = false, isFlippedX = false, isFlippedY = false;  ///< in this order
  int padding = 0;  ///< unknown cells added on each side
  int scale = 1;    ///< cells along the side of what was one cell
  Point shift;      ///< of the origin [m]
};

std::string nameOf(const Pose& pose);

/** The 4 turns and their mirror images. */
std::vector<Pose> symmetries();

/** Each symmetry as it is, shifted, at twice and at four times the resolution (unless the drawing
 *  counts in cells, as those for the paper's numbers do) and, where the map knows unknown cells,
 *  padded. */
std::vector<Pose> allPoses(const MapText& text);

MapText posed(const MapText& text, const Pose& pose);

/** Where a place of `text` lies in posed(text, pose). */
Point posed(Point p, const MapText& text, const Pose& pose);

}  // namespace roomgraph::test
