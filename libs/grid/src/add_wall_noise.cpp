#include "roomgraph/grid/add_wall_noise.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** The standard fixes what std::mt19937_64 gives, but not what its distributions make of it. */
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /** 0 to count - 1, all equally likely. */
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t end = largest - largest % count;  // a whole number of rounds
    std::uint64_t value = engine_();
    while (value >= end) value = engine_();
    return value % count;
  }

  int between(int low, int high) {
    return low + int(below(std::uint64_t(std::int64_t(high) - low + 1)));
  }

 private:
  std::mt19937_64 engine_;
};

void check(const WallNoise& noise) {
  if (!(noise.percent >= 0 && noise.percent <= 100))
    throw UsageError("wall noise of " + std::to_string(noise.percent) +
                     " percent: use 0 to 100 percent");
  if (noise.maxDistance < 0)
    throw UsageError("wall noise at a distance of " + std::to_string(noise.maxDistance) +
                     " cells: use 0 or more");
}

}  // namespace

Grid addWallNoise(const Grid& grid, const WallNoise& noise) {
  check(noise);
  Grid noisy = grid;
  std::vector<Cell> walls =
      grid.frame.cellsWhere([&](Cell c) { return grid.at(c) == State::occupied; });
  const auto count = std::size_t(std::llround(noise.percent / 100 * double(walls.size())));
  Random random(noise.seed);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(walls[i], walls[i + std::size_t(random.below(walls.size() - i))]);
    noisy.cells[grid.frame.index(walls[i])] = State::free;
  }
  // Ends: the freed cells themselves are within reach.
  for (std::size_t added = 0; added < count;) {
    Cell cell = walls[std::size_t(random.below(walls.size()))];
    cell.x += random.between(-noise.maxDistance, noise.maxDistance);
    cell.y += random.between(-noise.maxDistance, noise.maxDistance);
    if (!grid.frame.contains(cell) || noisy.at(cell) == State::occupied) continue;
    noisy.cells[grid.frame.index(cell)] = State::occupied;
    ++added;
  }
  return noisy;
}

}  // namespace roomgraph
