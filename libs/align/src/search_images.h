#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/grid/CellBox.h"

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
  /** Cells first to end - 1 of a row. */
  struct Span {
    int first = 0, end = 0;
  };
  static constexpr int kMargin = 15;  ///< of 0 behind each row, so that it is read 16 at a time

  int width = 0, height = 0;
  Cell low;  ///< the cell at index 0
  std::array<std::vector<std::int16_t>, kOctants> values;
  std::vector<Span> known;  ///< of each row; beyond it, all are 0

  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width + kMargin) + std::size_t(x);
  }
};

/** A wall point on the cells of the search. */
struct SearchPoint {
  Cell cell;
  int octant = 0;
  int times = 1;  ///< so many wall points are there
};

/** The smallest box round the points. */
CellBox boundingCells(const std::vector<SearchPoint>& points);

/** The walls of the map, turned by `angle`; every so manyth, so that there are at most `maxCount`.
 *  With `sign` -1, mirrored through the origin. */
std::vector<SearchPoint> searchPoints(const CentredMap& map, double angle, double cell,
                                      std::size_t maxCount, int sign);

/** What the map, turned by `angle` and mirrored as above, says about wall points: more than 0
 *  beside a wall that faces their way, less in free space, 0 where nothing is known. The map must
 *  have walls. */
SearchImages imagesOf(const CentredMap& map, double angle, double cell, int sign);

}  // namespace roomgraph
