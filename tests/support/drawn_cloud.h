#pragma once
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <vector>

namespace roomgraph::test {

using Points = std::vector<mrpt::math::TPoint3Df>;

/** The room of smallSimplemap(), from -2 to 2 m in x and y, with its floor 0.4 m below the robot,
 *  walls 2.5 m high and a table against the wall at x = 2, as points in the map's frame. */
Points roomPoints();

/** The points as a sensor at this pose has them. */
Points seenFrom(const mrpt::poses::CPose3D& sensor, const Points& points);

/** The bytes that all point maps begin with: how many, all x, all y, all z. */
std::string pointBytes(const Points& points);

/** A point map of this class and version, with `rest` behind its points. */
std::string pointsMapBytes(const std::string& className, int version, const Points& points,
                           const std::string& rest);

/** A CObservationPointCloud of a sensor at this pose on the robot, around the bytes that say where
 *  its points are. */
std::string cloudBytes(const mrpt::poses::CPose3D& sensor, const std::string& stored);

/** A simplemap of version 2 with one entry that holds the observation, with the robot at the
 *  origin. */
std::string oneObservation(const std::string& observation);

}  // namespace roomgraph::test
