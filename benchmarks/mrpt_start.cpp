// Does nothing but start with MRPT's libraries: what any program that links them pays.
#include <mrpt/maps/COccupancyGridMap2D.h>

int main() {
  const mrpt::maps::COccupancyGridMap2D map;
  return map.getSizeX() > 0 ? 0 : 1;
}
