#include "roomgraph/scans/find_slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr std::size_t kBeams = 3600;
constexpr float kNothing = HUGE_VALF;

/** FNV-1a. */
class Hash {
 public:
  void add(float value) {
    std::array<std::uint8_t, sizeof value> bytes;
    std::memcpy(bytes.data(), &value, sizeof value);
    for (const std::uint8_t byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t pointsId(const CloudPoints& points) {
  Hash hash;
  for (const auto& point : points) hash.add(point.x), hash.add(point.y), hash.add(point.z);
  return hash.value();
}

/** Fills directions between two points of one surface: a scanner has fewer than there are here. */
void bridgeGaps(std::vector<float>& ranges) {
  constexpr std::size_t widest = 10;  // a degree
  constexpr float deepest = 0.2f;     // between the points [m]
  for (std::size_t i = 0; i < kBeams; ++i) {
    if (ranges[i] == kNothing) continue;
    std::size_t gap = 1;
    while (gap <= widest && ranges[(i + gap) % kBeams] == kNothing) ++gap;
    const float here = ranges[i], there = ranges[(i + gap) % kBeams];
    if (gap == 1 || there == kNothing || std::abs(here - there) > deepest) continue;
    for (std::size_t k = 1; k < gap; ++k)
      ranges[(i + k) % kBeams] = here + (there - here) * float(k) / float(gap);
  }
}

// A height counts as a floor where it covers at least this share of what the widest one covers.
constexpr double kFloorShare = 0.3;
constexpr double kBandHeight = 0.5;   // [m]
constexpr double kLowestBand = 0.2;   // above the floor: its own noise, thresholds, cables [m]
constexpr double kHighestBand = 1.9;  // lintels of doors begin here [m]

constexpr int kBits = 24;  // of a place along each axis, and half of it of its height
constexpr std::int32_t kMiddle = 1 << (kBits - 1), kHeightMiddle = 1 << (kBits / 2 - 1);

using Layers = std::vector<std::vector<Voxels::Column>>;

/** Of the first `count` layers, the lowest one that covers much. */
std::size_t widestLow(const Layers& layers, std::size_t count) {
  std::size_t most = 0;
  for (std::size_t k = 0; k < count; ++k) most = std::max(most, layers[k].size());
  std::size_t k = 0;
  while (double(layers[k].size()) < kFloorShare * double(most)) ++k;
  // A floor spreads over two layers: the fuller one is meant.
  if (k + 1 < count && layers[k + 1].size() > 2 * layers[k].size()) ++k;
  return k;
}

/** Whether walls hang down from the layer, but none stand on it. */
bool isCeiling(const Layers& layers, std::size_t layer) {
  constexpr std::size_t own = 2;  // what belongs to the layer itself
  std::size_t below = 0, above = 0;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (k + own <= layer) below += layers[k].size();
    if (k >= layer + own) above += layers[k].size();
  }
  return below > 4 * above;
}

std::size_t floorLayer(const Layers& layers) {
  const std::size_t found = widestLow(layers, layers.size());
  if (!isCeiling(layers, found)) return found;
  return widestLow(layers, found - 1);
}

/** Whether much of what lies at this height has nothing standing on it in the layers from .. to. */
bool seesFloor(const std::vector<Voxels::Column>& floor, const Layers& layers, std::size_t from,
               std::size_t to) {
  constexpr double mostUnderWalls = 0.8;
  const auto key = [](const Voxels::Column& column) {
    return std::uint64_t(std::uint32_t(column.x)) << 32 | std::uint32_t(column.y);
  };
  std::unordered_set<std::uint64_t> walls;
  for (std::size_t k = from; k < std::min(to, layers.size()); ++k)
    for (const Voxels::Column& column : layers[k]) walls.insert(key(column));
  const auto under =
      countIf(floor, [&](const Voxels::Column& column) { return walls.count(key(column)) > 0; });
  return double(under) <= mostUnderWalls * double(floor.size());
}

/** How many cells of the band's walls lie in straight pieces. */
std::size_t straightCells(const Layers& layers, std::size_t from, std::size_t to) {
  std::vector<Cell> cells;
  for (std::size_t k = from; k < std::min(to, layers.size()); ++k)
    for (const Voxels::Column& column : layers[k]) cells.push_back({column.x, column.y});
  return countStraightCells(cells);
}

std::size_t steps(double height) { return std::size_t(std::lround(height / Voxels::kCube)); }

/** Sets where the band begins and ends. */
void chooseBand(const Layers& layers, std::size_t floor, Slice& slice) {
  std::size_t best = 0;
  for (std::size_t low = steps(kLowestBand); low + steps(kBandHeight) <= steps(kHighestBand);
       ++low) {
    const std::size_t found = straightCells(layers, floor + low, floor + low + steps(kBandHeight));
    if (slice.high > 0 && found * 20 <= best * 21) continue;
    best = found;
    slice.low = double(low) * Voxels::kCube;
    slice.high = slice.low + kBandHeight;
  }
}

bool isEmptyBand(const Layers& layers, const Slice& slice, double lowest) {
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const double bottom = lowest + double(k) * Voxels::kCube - slice.floor;
    if (!layers[k].empty() && bottom + Voxels::kCube >= slice.low && bottom <= slice.high)
      return false;
  }
  return true;
}

constexpr int kTurns = 36;  // directions of half a turn

/** A cell by the line of a direction that it is on, and how far along. */
struct Seen {
  std::int32_t line = 0, along = 0;
  std::uint32_t cell = 0;
};

/** Sets run[i] to the length of the piece that cell i is part of in the direction. */
void measureRuns(const std::vector<Cell>& cells, double angle, std::vector<std::int32_t>& run) {
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<Seen> seen(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    seen[i] = {std::int32_t(std::lround(c * cells[i].y - s * cells[i].x)),
               std::int32_t(std::lround(c * cells[i].x + s * cells[i].y)), i};
  std::sort(seen.begin(), seen.end(), [](const Seen& l, const Seen& r) {
    return std::tie(l.line, l.along, l.cell) < std::tie(r.line, r.along, r.cell);
  });
  for (std::size_t first = 0, i = 0; i < seen.size(); ++i) {
    const bool isLast = i + 1 == seen.size() || seen[i + 1].line != seen[i].line ||
                        seen[i + 1].along - seen[i].along > 3;
    if (!isLast) continue;
    const std::int32_t length = seen[i].along - seen[first].along + 1;
    for (; first <= i; ++first) run[seen[first].cell] = length;
  }
}

}  // namespace

std::uint64_t rangesId(const RangeScan& scan) {
  Hash hash;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    hash.add(scan.isValid[i] ? scan.ranges[i] : -1);
  return hash.value();
}

PlacedScan sliceScan(const CloudPoints& points, const mrpt::poses::CPose3D& sensor, double ground,
                     const Slice& slice) {
  std::vector<float> ranges(kBeams, kNothing);
  for (const auto& point : points) {
    const auto p = sensor.composePoint(mrpt::math::TPoint3D(point));
    const double dx = p.x - sensor.x(), dy = p.y - sensor.y(), range = std::hypot(dx, dy);
    // What is nearer than 0.2 m is the robot itself.
    if (range < 0.2 || !slice.contains(p.z - ground)) continue;
    const double turns = std::atan2(dy, dx) / (2 * M_PI) + 0.5;
    auto& nearest = ranges[std::size_t(std::lround(turns * kBeams)) % kBeams];
    nearest = std::min(nearest, float(range));
  }
  bridgeGaps(ranges);
  PlacedScan placed;
  placed.from = mrpt::poses::CPose3D(sensor.x(), sensor.y(), 0);
  placed.id = pointsId(points);
  RangeScan& scan = placed.scan;
  scan.aperture = float(2 * M_PI);
  scan.maxRange = 80;  // what MRPT takes for granted where nobody says it [m]
  scan.isValid.resize(kBeams);
  for (std::size_t i = 0; i < kBeams; ++i) {
    scan.isValid[i] = ranges[i] != kNothing;
    if (!scan.isValid[i]) ranges[i] = 0;
  }
  scan.ranges = std::move(ranges);
  return placed;
}

void Voxels::add(double x, double y, double z) {
  constexpr double farthest = 1e4, highest = 100;
  if (!(std::abs(x) < farthest && std::abs(y) < farthest && std::abs(z) < highest)) return;
  if (cubes_.size() >= 20'000'000) return;  // more memory would tell no more
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
  constexpr std::size_t flatLayers = 4;  // of a 2D scanner on a robot that rocks
  if (layers.size() <= flatLayers) {
    slice.floor = voxels.lowest();
    slice.isFlat = true;
    return slice;
  }
  const std::size_t floor = floorLayer(layers);
  slice.floor = voxels.lowest() + (double(floor) + 0.5) * Voxels::kCube;
  slice.low = options.sliceLow, slice.high = options.sliceHigh;
  if (options.sliceHigh <= 0) chooseBand(layers, floor, slice);
  slice.isFloorSeen =
      seesFloor(layers[floor], layers, floor + steps(kLowestBand), floor + steps(kHighestBand));
  slice.isEmpty = isEmptyBand(layers, slice, voxels.lowest());
  return slice;
}

void refuseEmptySlice(const Slice& slice, const std::string& file) {
  if (slice.isEmpty)
    refuse(file, "has no points at " + sliceText(slice), "choose other heights with --slice");
}

std::string sliceText(const Slice& slice) {
  if (slice.isFlat) return "all points, which lie in one plane";
  return formatted("heights %.2f to %.2f m above the %s at %.2f m", slice.low, slice.high,
                   slice.isFloorSeen ? "floor" : "lowest walls, as no floor was seen,",
                   slice.floor);
}

std::size_t countStraightCells(std::vector<Cell> cells) {
  const auto key = [](Cell c) { return std::make_pair(c.y, c.x); };
  std::sort(cells.begin(), cells.end(), [&](Cell l, Cell r) { return key(l) < key(r); });
  cells.erase(
      std::unique(cells.begin(), cells.end(), [&](Cell l, Cell r) { return key(l) == key(r); }),
      cells.end());
  // By half turns: across direction k is direction k + kTurns / 2.
  std::vector<std::vector<std::int32_t>> runs(kTurns);
  for (int k = 0; k < kTurns; ++k) {
    runs[std::size_t(k)].resize(cells.size());
    measureRuns(cells, M_PI * k / kTurns, runs[std::size_t(k)]);
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < kTurns; ++k)
      if (runs[k][i] > runs[longest][i]) longest = k;
    const std::int32_t across = runs[(longest + kTurns / 2) % kTurns][i];
    count += runs[longest][i] >= 10 && across <= 3;
  }
  return count;
}

}  // namespace roomgraph
