#include "roomgraph/relate/noise_floor.h"

#include <cmath>

#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

double noiseFloor(const Grid& grid, const MapForAlignment& map, const NoiseFloorOptions& options) {
  if (map.walls.empty() || options.repeats < 1) return 0;
  WallNoise noise = options.noise;
  double squares = 0;
  for (int i = 0; i < options.repeats; ++i, ++noise.seed) {
    const MapForAlignment noisy = wallsForAlignment(addWallNoise(grid, noise), {});
    const double bend = followWalls(noisy, map, {{}}, {}).bend;
    squares += bend * bend;
  }
  return std::sqrt(squares / options.repeats);
}

}  // namespace roomgraph
