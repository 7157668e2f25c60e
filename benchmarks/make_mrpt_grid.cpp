#include "make_mrpt_grid.h"

namespace roomgraph {

mrpt::maps::COccupancyGridMap2D makeMrptGrid(const GreyMap& map) {
  const GridFrame& frame = map.frame;
  mrpt::maps::COccupancyGridMap2D grid;
  grid.setSize(float(frame.origin.x), float(frame.origin.x + frame.width * frame.resolution),
               float(frame.origin.y), float(frame.origin.y + frame.height * frame.resolution),
               float(frame.resolution));
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      grid.setCell(x, y, float(map.grey[frame.index({x, y})]) / 255);
  return grid;
}

}  // namespace roomgraph
