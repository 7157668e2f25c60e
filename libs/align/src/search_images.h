#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallMap.h"

namespace roomgraph {

/** A map moved so that its middle is the origin: turns then shift it least. */
struct CentredMap {
  struct FreePlace {
    Point place;
    bool isDeep = false;  ///< in the middle of free space
  };
  std::vector<WallPoint> walls;
  std::vector<FreePlace> freePlaces;
};

CentredMap centred(const WallMap& map);

/** What a wall point is worth in each cell, by the octant of its normal. */
struct SearchImages {
  int width = 0, height = 0;
  Cell low;  ///< the cell at index 0
  std::array<std::vector<std::int16_t>, kOctants> values;
};

/** A wall point on the cells of the search. */
struct SearchPoint {
  Cell cell;
  int octant = 0;
};

/** The walls of the map, turned by `angle`; every so manyth, so that there are at most `maxCount`.
 *  With `sign` -1, mirrored through the origin. */
std::vector<SearchPoint> searchPoints(const CentredMap& map, double angle, double cell,
                                      std::size_t maxCount, int sign);

/** What the map, turned by `angle` and mirrored as above, says about wall points: more than 0
 *  beside a wall that faces their way, less in free space, 0 where nothing is known. The map must
 *  have walls. */
SearchImages imagesOf(const CentredMap& map, double angle, double cell, int sign);

}  // namespace roomgraph
