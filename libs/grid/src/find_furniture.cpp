#include "find_furniture.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Polygon.h"
#include "wall_ahead.h"

namespace roomgraph {
namespace {

/** Of the size of the largest clutter: how wide furniture is, from what is thicker than a wall to a
 *  table; and how much space it has round it, which is the width of a robot. */
constexpr double kThinnest = 0.25, kWidest = 2, kApart = 0.4;
/** Of its convex hull, and with what beams have missed of it. */
constexpr double kSolid = 0.75;
/** A cell with fewer of its neighbours and itself is a speck. */
constexpr int kMostOfNine = 5;

class FurnitureFinder {
 public:
  FurnitureFinder(const Grid& grid, double maxSize) : grid_(grid), maxSize_(maxSize) {}

  std::vector<ClutterGroup> among(std::vector<ClutterGroup> groups) {
    eraseIf(groups, [&](const ClutterGroup& group) { return !isBlock(group) || !isApart(group); });
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (const Cell cell : groups[i].cells) groupAt_[grid_.frame.index(cell)] = i;
    findPiers(groups);
    std::size_t i = 0;
    eraseIf(groups, [&](const ClutterGroup&) { return isPier_[i++]; });
    return groups;
  }

 private:
  double cells(double share) const { return share * maxSize_ / grid_.frame.resolution; }

  /** Whether it only sticks to what it belongs to. */
  bool isSpeck(Cell cell) const {
    int solid = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        solid += grid_.atOrUnknown({cell.x + dx, cell.y + dy}) != State::free ? 1 : 0;
    return solid < kMostOfNine;
  }

  ClutterGroup withoutSpecks(ClutterGroup group) const {
    eraseIf(group.cells, [&](Cell cell) { return isSpeck(cell); });
    group.box = {};
    for (const Cell cell : group.cells) group.box.include(cell);
    return group;
  }

  bool isBlock(const ClutterGroup& group) const {
    const ClutterGroup core = withoutSpecks(group);
    if (core.cells.empty()) return false;
    const Ring hull = convexHull(cornersOf(core));
    const double width = leastWidth(hull);
    return width >= cells(kThinnest) && width <= cells(kWidest) &&
           double(core.cells.size()) >= kSolid * signedArea(hull);
  }

  bool isApart(const ClutterGroup& group) const {
    const int reach = int(cells(kApart)), width = group.box.width();
    const auto index = [&](Cell cell) {
      return std::size_t(cell.y - group.box.low.y) * std::size_t(width) +
             std::size_t(cell.x - group.box.low.x);
    };
    std::vector<std::uint8_t> isOwn(std::size_t(width) * std::size_t(group.box.height()));
    for (const Cell cell : group.cells) isOwn[index(cell)] = 1;
    const auto isOther = [&](Cell cell) {
      return grid_.frame.contains(cell) && grid_.at(cell) != State::free &&
             !(group.box.contains(cell) && isOwn[index(cell)]);
    };
    return allOf(group.cells, [&](Cell cell) {
      if (grid_.countBeside(cell, State::free) == 0) return true;
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
          if (dx * dx + dy * dy <= reach * reach && isOther({cell.x + dx, cell.y + dy}))
            return false;
      return true;
    });
  }

  /** Piers are in line with a wall, or with another pier; so the last one of a row of shelves would
   *  have to be in line with a wall before any of them is. */
  void findPiers(const std::vector<ClutterGroup>& groups) {
    std::vector<std::vector<std::size_t>> lines;  // the cells where what is in line with it begins
    for (const ClutterGroup& group : groups) lines.push_back(inLineWith(group));
    isPier_.assign(groups.size(), 0);
    const auto isWall = [&](std::size_t cell) {
      const auto it = groupAt_.find(cell);
      return it == groupAt_.end() || isPier_[it->second];
    };
    for (bool isAny = true; isAny;) {
      isAny = false;
      for (std::size_t i = 0; i < groups.size(); ++i)
        if (!isPier_[i] && anyOf(lines[i], isWall)) isPier_[i] = isAny = true;
    }
  }

  /** Along both of its axes, as a square has two, and on two lines on either side of its middle. A
   *  quarter of a cell keeps these off the borders of cells, where the map's pose would decide. */
  std::vector<std::size_t> inLineWith(const ClutterGroup& group) const {
    std::vector<std::size_t> found;
    const Point axis = directionOf(group);
    for (const Point along : {axis, toLeft(axis), -1 * axis, -1 * toLeft(axis)}) {
      const double width = widthAcross(group, along), length = widthAcross(group, toLeft(along));
      const Point end = group.middle() + (std::floor(length / 2) + 0.25) * along;
      for (const double side : {-1.0, 1.0}) {
        const Point start = end + side * (std::floor(width / 4) + 0.25) * toLeft(along);
        const auto wall = acrossGap(grid_, start, along, cells(kWidestGap));
        if (wall && wallGoesOn(grid_, *wall, along, width))
          found.push_back(grid_.frame.index(cellAt(*wall)));
      }
    }
    return found;
  }

  const Grid& grid_;
  double maxSize_;                                        // [m]
  std::unordered_map<std::size_t, std::size_t> groupAt_;  // by the index of a cell
  std::vector<std::uint8_t> isPier_;                      // per group
};

}  // namespace

std::vector<ClutterGroup> furnitureAmong(std::vector<ClutterGroup> groups, const Grid& grid,
                                         double maxSize) {
  return FurnitureFinder(grid, maxSize).among(std::move(groups));
}

}  // namespace roomgraph
