#include "roomgraph/scans/find_slice.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/sentence_text.h"
#include "straight_cells.h"

namespace roomgraph {
namespace {

// A height counts as a floor where it covers at least this share of what the widest one covers.
constexpr double kFloorShare = 0.3;
constexpr double kBandHeight = 0.5;   // [m]
constexpr double kLowestBand = 0.2;   // above the floor: its own noise, thresholds, cables [m]
constexpr double kHighestBand = 1.9;  // lintels of doors begin here [m]

constexpr std::size_t kMostCubes = 20'000'000;  // more memory would tell no more
constexpr int kBits = 24, kHeightBits = 12;
constexpr std::int32_t kMiddle = 1 << (kBits - 1), kHeightMiddle = 1 << (kHeightBits - 1);

std::size_t floorLayer(const std::vector<std::vector<Voxels::Column>>& layers) {
  std::size_t most = 0;
  for (const auto& layer : layers) most = std::max(most, layer.size());
  std::size_t k = 0;
  while (double(layers[k].size()) < kFloorShare * double(most)) ++k;
  // A floor spreads over two layers: the fuller one is meant.
  if (k + 1 < layers.size() && layers[k + 1].size() > 2 * layers[k].size()) ++k;
  return k;
}

/** How many cells of the band's walls lie in straight pieces. */
std::size_t straightCells(const std::vector<std::vector<Voxels::Column>>& layers, std::size_t from,
                          std::size_t to) {
  std::vector<Cell> cells;
  for (std::size_t k = from; k < std::min(to, layers.size()); ++k)
    for (const Voxels::Column& column : layers[k]) cells.push_back({column.x, column.y});
  return countStraightCells(cells);
}

}  // namespace

void Voxels::add(double x, double y, double z) {
  constexpr double farthest = 1e4, highest = 100;
  if (!(std::abs(x) < farthest && std::abs(y) < farthest && std::abs(z) < highest)) return;
  if (cubes_.size() >= kMostCubes) return;
  const auto index = [](double value, std::int32_t middle) {
    return std::uint64_t(std::int64_t(std::floor(value / kCube)) + middle);
  };
  cubes_.insert(index(z, kHeightMiddle) << (2 * kBits) | index(y, kMiddle) << kBits |
                index(x, kMiddle));
}

double Voxels::lowest() const {
  std::uint64_t low = UINT64_MAX;
  for (const std::uint64_t cube : cubes_) low = std::min(low, cube >> (2 * kBits));
  return (double(low) - kHeightMiddle) * kCube;
}

std::vector<std::vector<Voxels::Column>> Voxels::layers() const {
  const auto first = std::int64_t(std::lround(lowest() / kCube)) + kHeightMiddle;
  std::vector<std::vector<Column>> layers;
  constexpr std::uint64_t mask = (std::uint64_t(1) << kBits) - 1;
  for (const std::uint64_t cube : cubes_) {
    const auto k = std::size_t(std::int64_t(cube >> (2 * kBits)) - first);
    if (k >= layers.size()) layers.resize(k + 1);
    layers[k].push_back(
        {std::int32_t(cube & mask) - kMiddle, std::int32_t(cube >> kBits & mask) - kMiddle});
  }
  return layers;
}

Slice findSlice(const Voxels& voxels, const LoadGridOptions& options) {
  Slice slice;
  const auto layers = voxels.layers();
  constexpr std::size_t flatLayers = 2;
  if (layers.size() <= flatLayers) {
    slice.floor = voxels.lowest();
    slice.isFlat = true;
    return slice;
  }
  const std::size_t floor = floorLayer(layers);
  slice.floor = voxels.lowest() + (double(floor) + 0.5) * Voxels::kCube;
  slice.low = options.sliceLow, slice.high = options.sliceHigh;
  if (options.sliceHigh > 0) return slice;

  const auto steps = [](double height) { return std::size_t(std::lround(height / Voxels::kCube)); };
  std::size_t best = 0;
  for (std::size_t low = steps(kLowestBand); low + steps(kBandHeight) <= steps(kHighestBand);
       ++low) {
    const std::size_t found = straightCells(layers, floor + low, floor + low + steps(kBandHeight));
    if (slice.high > 0 && found * 20 <= best * 21) continue;
    best = found;
    slice.low = double(low) * Voxels::kCube;
    slice.high = slice.low + kBandHeight;
  }
  return slice;
}

std::string sliceText(const Slice& slice) {
  if (slice.isFlat) return "all points, which lie in one plane";
  return formatted("heights %.2f to %.2f m above the floor at %.2f m", slice.low, slice.high,
                   slice.floor);
}

}  // namespace roomgraph
