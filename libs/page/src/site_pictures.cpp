#include "roomgraph/page/site_pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr std::uint8_t kWallAlphas[] = {110, 170, 220, 255};  // by their share of a pixel, of 255

/** Calls `use(place in the site, state)` for each known cell. */
template <class Use>
void forKnownCells(const PlacedMap& placed, const Use& use) {
  const WallMap& map = *placed.map;
  const Motion2D move(placed.pose);
  for (int y = 0; y < map.frame.height; ++y)
    for (int x = 0; x < map.frame.width; ++x) {
      const State state = map.states[map.frame.index({x, y})];
      if (state != State::unknown) use(move(map.frame.center({x, y})), state);
    }
}

Box boundsOf(const PlacedMap& placed) {
  Box box;
  forKnownCells(placed, [&](Point p, State) { box.include(p); });
  return box.widened(0.71 * placed.map->frame.resolution);  // a turned cell
}

/** The box widened to whole cells of a raster through the origin. */
GridFrame rasterOver(const Box& box, double cell) {
  const double x = std::floor(box.low.x / cell), y = std::floor(box.low.y / cell);
  GridFrame frame;
  frame.resolution = cell;
  frame.origin = {x * cell, y * cell};
  frame.width = std::max(1, int(std::ceil(box.high.x / cell) - x));
  frame.height = std::max(1, int(std::ceil(box.high.y / cell) - y));
  return frame;
}

Box boxOf(const GridFrame& frame) {
  const Point size{frame.width * frame.resolution, frame.height * frame.resolution};
  return {frame.origin, frame.origin + size};
}

/** What a pixel shows, from samples spread over it: 0 nothing, 1 free, 2 to 5 more and more wall.
 */
class Sampler {
 public:
  /** Where the runs of a site lie so far apart that a map is less than a pixel, there are no more
   *  samples than it has cells. */
  Sampler(const PlacedMap& placed, double pixel)
      : map_(*placed.map),
        side_(std::max(2, int(std::min(std::ceil(pixel / map_.frame.resolution),
                                       double(std::max(map_.frame.width, map_.frame.height)))))) {
    const Motion2D toMap(placed.pose.inverse());
    const double perCell = 1 / map_.frame.resolution, step = pixel / side_;
    origin_ = perCell * (toMap(Point{}) - map_.frame.origin);
    along_ = perCell * toMap.turned({1, 0}), up_ = perCell * toMap.turned({0, 1});
    for (int j = 0; j < side_; ++j)
      for (int i = 0; i < side_; ++i)
        samples_.push_back(step * (i + 0.5) * along_ + step * (j + 0.5) * up_);
  }

  std::uint8_t at(Point corner) const {
    const Point first = origin_ + corner.x * along_ + corner.y * up_;  // in cells
    int walls = 0, free = 0;
    for (const Point sample : samples_) {
      const Point p = first + sample;
      if (!(p.x >= 0 && p.y >= 0 && p.x < map_.frame.width && p.y < map_.frame.height)) continue;
      const State state = map_.states[map_.frame.index({int(p.x), int(p.y)})];
      walls += state == State::occupied;
      free += state == State::free;
    }
    // A wall that crosses the pixel covers few of many samples.
    if (walls > 0) return std::uint8_t(1 + std::min(4, (2 * walls + side_ - 1) / side_));
    return 2 * free >= side_ * side_ ? 1 : 0;
  }

 private:
  const WallMap& map_;
  int side_;
  Point origin_, along_, up_;   // of the site, in cells of the map
  std::vector<Point> samples_;  // from the corner of a pixel, in cells
};

/** What a pixel shows in a pattern: between the threads a wall is as weak as can be. */
std::uint8_t weave(std::uint8_t shown, RunPattern pattern, int x, int y) {
  constexpr int thread = 4;  // [px]
  const auto isOdd = [](int along) { return (along / thread) % 2 == 1; };
  const bool isGap = pattern == RunPattern::rising    ? isOdd(x + y)
                     : pattern == RunPattern::falling ? isOdd(x - y + (1 << 20))
                     : pattern == RunPattern::dotted  ? isOdd(x) != isOdd(y)
                                                      : false;
  return isGap ? std::min<std::uint8_t>(shown, 1) : shown;  // as Sampler has free space
}

/** For each cell what one run has seen there. */
struct Looks {
  std::vector<std::uint8_t> hasWall, hasFree;
};

Looks looksOf(const PlacedMap& placed, const GridFrame& frame) {
  Looks looks;
  looks.hasWall.assign(frame.cellCount(), 0);
  looks.hasFree.assign(frame.cellCount(), 0);
  forKnownCells(placed, [&](Point p, State state) {
    const Cell cell = frame.cellAt(p);
    if (!frame.contains(cell)) return;
    (state == State::occupied ? looks.hasWall : looks.hasFree)[frame.index(cell)] = 1;
  });
  return looks;
}

bool isWallNear(const Looks& looks, const GridFrame& frame, Cell cell) {
  for (int y = cell.y - 1; y <= cell.y + 1; ++y)
    for (int x = cell.x - 1; x <= cell.x + 1; ++x)
      if (frame.contains({x, y}) && looks.hasWall[frame.index({x, y})]) return true;
  return false;
}

}  // namespace

Box knownBox(const std::vector<PlacedMap>& maps) {
  Box all;
  for (const PlacedMap& placed : maps) {
    const Box box = boundsOf(placed);
    if (box.isEmpty()) continue;
    all.include(box.low), all.include(box.high);
  }
  return all.isEmpty() ? Box{{0, 0}, {1, 1}} : all;
}

double pixelFor(const Box& site, const std::vector<PlacedMap>& maps, int most) {
  double finest = std::numeric_limits<double>::infinity();
  for (const PlacedMap& placed : maps) finest = std::min(finest, placed.map->frame.resolution);
  const double needed = std::max(site.high.x - site.low.x, site.high.y - site.low.y) / (most - 1);
  return maps.empty() ? needed : std::max(finest / 2, needed);
}

SitePicture runPicture(const PlacedMap& placed, const RunInk& ink, double pixel) {
  const Box box = boundsOf(placed);
  if (box.isEmpty()) return {{{0, 0}, {1, 1}}, ""};
  const GridFrame frame = rasterOver(box, pixel);
  PaletteImage image{frame.width, frame.height, std::vector<Colour>(6, ink.colour), {}, {}};
  image.alphas = {0, ink.faint, kWallAlphas[0], kWallAlphas[1], kWallAlphas[2], kWallAlphas[3]};
  image.indices.reserve(frame.cellCount());
  const Sampler sampler(placed, pixel);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      image.indices.push_back(
          weave(sampler.at(frame.origin + pixel * Point{double(x), double(y)}), ink.pattern, x, y));
  return {boxOf(frame), pngBytes(image)};
}

Disagreement disagreementOf(const std::vector<PlacedMap>& maps, double cell) {
  Disagreement result;
  result.frame = rasterOver(knownBox(maps), cell);
  const GridFrame& frame = result.frame;
  std::vector<int> walls(frame.cellCount()), free(frame.cellCount());
  for (const PlacedMap& placed : maps) {
    const Looks looks = looksOf(placed, frame);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const std::size_t i = frame.index({x, y});
        if (looks.hasWall[i])
          ++walls[i];
        else if (looks.hasFree[i] && !isWallNear(looks, frame, {x, y}))
          ++free[i];
      }
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const int looked = walls[i] + free[i];
    result.shares.push_back(looked < 2 ? 0 : float(std::min(walls[i], free[i])) / float(looked));
  }
  return result;
}

const std::vector<Colour>& heatColours() {
  static const std::vector<Colour> colours = {
      {254, 227, 145}, {254, 196, 79}, {254, 153, 41}, {217, 95, 14}, {153, 52, 4}};
  return colours;
}

int heatLevel(double share) {
  const int classes = int(heatColours().size());
  return std::clamp(int(std::ceil(2 * classes * share - 1e-6)), 0, classes);
}

SitePicture heatPicture(const Disagreement& disagreement) {
  const GridFrame& frame = disagreement.frame;
  if (!anyOf(disagreement.shares, [](float share) { return share > 0; })) return {boxOf(frame), ""};
  PaletteImage image{frame.width, frame.height, {{}}, {}, {0}};
  image.palette.insert(image.palette.end(), heatColours().begin(), heatColours().end());
  image.alphas.resize(image.palette.size(), 225);
  for (const float share : disagreement.shares)
    image.indices.push_back(std::uint8_t(heatLevel(double(share))));
  return {boxOf(frame), pngBytes(image)};
}

}  // namespace roomgraph
