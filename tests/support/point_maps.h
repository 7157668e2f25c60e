#pragma once
// The classes of points that this MRPT has. They are made by name: MRPT 2.15 warns of those with
// colours or intensities, for which CGenericPointsMap stands, and MRPT 3 lacks them.
#include <mrpt/maps/CPointsMap.h>
#include <mrpt/rtti/CObject.h>

#include <vector>

namespace roomgraph::test {

/** An empty one of each class. */
inline std::vector<mrpt::maps::CPointsMap::Ptr> pointMaps() {
  std::vector<mrpt::maps::CPointsMap::Ptr> maps;
  for (const char* name : {"mrpt::maps::CSimplePointsMap", "mrpt::maps::CWeightedPointsMap",
                           "mrpt::maps::CGenericPointsMap", "mrpt::maps::CColouredPointsMap",
                           "mrpt::maps::CPointsMapXYZI"})
    if (auto map =
            std::dynamic_pointer_cast<mrpt::maps::CPointsMap>(mrpt::rtti::classFactory(name)))
      maps.push_back(map);
  return maps;
}

}  // namespace roomgraph::test
