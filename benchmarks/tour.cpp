#include "tour.h"

#include <algorithm>

#include "FloorPlan.h"
#include "Random.h"

namespace roomgraph {
namespace {

constexpr int kStep = 4;    // between the places of the lattice [cells]
constexpr int kRadius = 6;  // of the robot [cells]
constexpr int kSight = 15;  // from which on a place has been visited [steps]

/** The places of a coarse lattice on which the robot can stand. */
class Lattice {
 public:
  explicit Lattice(const GreyMap& map)
      : map_(map), width_(map.frame.width / kStep), height_(map.frame.height / kStep) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) isFree_.push_back(hasRoom(x, y));
  }

  std::vector<int> freePlaces() const {
    std::vector<int> places;
    for (int i = 0; i < int(isFree_.size()); ++i)
      if (isFree_[std::size_t(i)]) places.push_back(i);
    return places;
  }

  /** The shortest way from `from`, without it, to the nearest place that is marked; empty without
   *  one. */
  std::vector<int> wayTo(int from, const std::vector<char>& isMarked) const {
    std::vector<int> before(isFree_.size(), -1), queue{from};
    before[std::size_t(from)] = from;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const int at = queue[next];
      if (at != from && isMarked[std::size_t(at)]) return wayBack(from, at, before);
      for (const int to : neighbours(at))
        if (isFree_[std::size_t(to)] && before[std::size_t(to)] < 0) {
          before[std::size_t(to)] = at;
          queue.push_back(to);
        }
    }
    return {};
  }

  void clearAround(int place, std::vector<char>& isMarked) const {
    const int px = place % width_, py = place / width_;
    for (int y = std::max(0, py - kSight); y <= std::min(height_ - 1, py + kSight); ++y)
      for (int x = std::max(0, px - kSight); x <= std::min(width_ - 1, px + kSight); ++x)
        isMarked[std::size_t(y) * std::size_t(width_) + std::size_t(x)] = 0;
  }

  Point at(int place) const {
    return map_.frame.center({place % width_ * kStep, place / width_ * kStep});
  }
  std::size_t size() const { return isFree_.size(); }

 private:
  bool hasRoom(int x, int y) const {
    for (int dy = -kRadius; dy <= kRadius; ++dy)
      for (int dx = -kRadius; dx <= kRadius; ++dx) {
        const int cx = x * kStep + dx, cy = y * kStep + dy;
        if (cx < 0 || cy < 0 || cx >= map_.frame.width || cy >= map_.frame.height) return false;
        if (map_.grey[map_.frame.index({cx, cy})] != grey::kFree) return false;
      }
    return true;
  }

  std::vector<int> neighbours(int at) const {
    std::vector<int> all;
    if (at % width_ > 0) all.push_back(at - 1);
    if (at % width_ + 1 < width_) all.push_back(at + 1);
    if (at >= width_) all.push_back(at - width_);
    if (at + width_ < int(isFree_.size())) all.push_back(at + width_);
    return all;
  }

  static std::vector<int> wayBack(int from, int to, const std::vector<int>& before) {
    std::vector<int> way;
    for (int at = to; at != from; at = before[std::size_t(at)]) way.push_back(at);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const GreyMap& map_;
  int width_, height_;
  std::vector<char> isFree_;
};

}  // namespace

std::vector<Point> tour(const GreyMap& map, std::uint32_t seed) {
  const Lattice lattice(map);
  const std::vector<int> free = lattice.freePlaces();
  if (free.empty()) return {};
  std::vector<char> isLeft(lattice.size());
  for (const int place : free) isLeft[std::size_t(place)] = 1;
  const int start = free[std::size_t(Random(seed).below(int(free.size())))];
  std::vector<Point> corners{lattice.at(start)};
  std::vector<char> isStart(lattice.size());
  isStart[std::size_t(start)] = 1;
  lattice.clearAround(start, isLeft);
  int at = start;
  for (bool isHome = false; !isHome;) {
    std::vector<int> way = lattice.wayTo(at, isLeft);
    isHome = way.empty();
    if (isHome) way = lattice.wayTo(at, isStart);
    for (const int place : way) {
      corners.push_back(lattice.at(place));
      lattice.clearAround(place, isLeft);
      at = place;
    }
  }
  return corners;
}

}  // namespace roomgraph
