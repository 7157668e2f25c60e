#pragma once
#include <vector>

#include "roomgraph/grid/Grid.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph::test {

/** A drive along the longest free row of a map, of several beside each other the middle one, with a
 *  scan of 270 degrees each half metre and true poses. */
std::vector<Keyframe> drawnDrive(const Grid& grid);

/** The scans that a robot at these poses takes. */
std::vector<Keyframe> drawnDrive(const Grid& grid, const std::vector<Transform2D>& poses);

/** The same drive with everything from scan `from` on turned about the robot and shifted. */
std::vector<Keyframe> broken(std::vector<Keyframe> frames, std::size_t from, double turn,
                             Point shift);

/** The same drive with a heading that drifts by `turn` at each key frame [rad]. */
std::vector<Keyframe> drifting(std::vector<Keyframe> frames, double turn);

/** The same drive in another frame. */
std::vector<Keyframe> moved(std::vector<Keyframe> frames, const Transform2D& motion);

/** The map that these scans draw: free along their beams, occupied at the ends. Cells of 0.05 m. */
Grid mapDrawnBy(const std::vector<Keyframe>& frames);

}  // namespace roomgraph::test
