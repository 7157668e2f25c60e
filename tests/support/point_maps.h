#pragma once
// The classes of points that this MRPT has: from 3 on, CGenericPointsMap stands for those with
// colours or intensities.
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/maps/CWeightedPointsMap.h>
#if __has_include(<mrpt/maps/CGenericPointsMap.h>)
#include <mrpt/maps/CGenericPointsMap.h>
#endif
#if __has_include(<mrpt/maps/CColouredPointsMap.h>)
#include <mrpt/maps/CColouredPointsMap.h>
#endif
#if __has_include(<mrpt/maps/CPointsMapXYZI.h>)
#include <mrpt/maps/CPointsMapXYZI.h>
#endif

#include <vector>

namespace roomgraph::test {

/** An empty one of each class. */
inline std::vector<mrpt::maps::CPointsMap::Ptr> pointMaps() {
  return {
    mrpt::maps::CSimplePointsMap::Create(), mrpt::maps::CWeightedPointsMap::Create(),
#if __has_include(<mrpt/maps/CGenericPointsMap.h>)
        mrpt::maps::CGenericPointsMap::Create(),
#endif
#if __has_include(<mrpt/maps/CColouredPointsMap.h>)
        mrpt::maps::CColouredPointsMap::Create(),
#endif
#if __has_include(<mrpt/maps/CPointsMapXYZI.h>)
        mrpt::maps::CPointsMapXYZI::Create(),
#endif
  };
}

}  // namespace roomgraph::test
