#pragma once
#include <vector>

#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph::test {

/** Poses of key frames, in their order. */
using Way = std::vector<Transform2D>;

/** Once round a block of 20 m by 10 m, a pose each metre from `offset` on, heading along it. */
Way roundTheBlock(double offset = 0);

/** The same way, which turns by `turn` too far with each step. */
Way drifting(const Way& way, double turn);

/** The same way with everything from pose `from` on turned about the robot and shifted. */
Way torn(const Way& way, std::size_t from, double turn, Point shift);

/** The same way in another frame. */
Way moved(const Way& way, const Transform2D& motion);

/** What each of the submaps below has drawn [m, frame of the submap]. */
const std::vector<Point>& drawnPoints();

/** A run whose key frames lie at `way`, each linked to the next. */
RunSubmaps drawnSubmaps(const Way& way);

/** Each pose of each way in the nearest one of each other way, exactly, where one is within 2 m. */
std::vector<RunMatches> exactMatches(const std::vector<Way>& truth);

/** Root mean square distance of what submaps have drawn at two ways, after the best motion [m]. */
double displacement(const Way& way, const Way& truth);

/** Root mean square distance of all poses, after the best motion of all runs together [m]. */
double misplaced(const SubmapPoses& poses, const std::vector<Way>& truth);

}  // namespace roomgraph::test
