#include "find_leaves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "ClutterGroup.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Transform2D.h"
#include "wall_ahead.h"

namespace roomgraph {
namespace {

/** Of the size of the largest clutter, which is that of the longest leaf: how long and how thick
 *  leaves are. */
constexpr double kShortest = 0.5, kThickest = 0.125;
/** Of its length, how wide the doorway of a leaf is. */
constexpr double kNarrowDoorway = 0.7, kWideDoorway = 1.35;
/** By how much a leaf leans from a right angle with its wall at most: a tangent. */
constexpr double kLean = 0.47;
/** How far cells of what is straight lie beside its line [cells]. */
constexpr double kRagged = 1.5;
/** In so many directions one looks round the end of a leaf; a quarter of them is solid at most. */
constexpr int kLooksRound = 32;
/** To either side, off the borders of cells, where the map's pose would decide [cells]. */
constexpr double kBesideBorders[] = {-0.25, 0.25};

Point middleOf(Cell cell) { return {double(cell.x), double(cell.y)}; }

/** Something thin and straight, from its free end to the wall that it hangs at [cells]. */
struct Leaf {
  std::vector<Cell> cells;
  Point end, way;
  double thickness = 0, length = 0;

  double along(Cell cell) const { return dot(way, middleOf(cell) - end); }
  /** How far a cell lies off it. */
  double off(Cell cell) const {
    return std::abs(cross(way, middleOf(cell) - end)) - thickness / 2 - kRagged;
  }
};

/** Where a leaf meets its wall, its way, and the way to one side of it [cells]. */
struct Hinge {
  Point place, way, out;
};

class LeafFinder {
 public:
  LeafFinder(const Grid& grid, double maxSize)
      : grid_(grid),
        longest_(maxSize / grid.frame.resolution),
        thick_(int(kThickest * longest_) + 1) {
    for (int k = 0; k < kLooksRound; ++k)
      round_.push_back(cellAt((thick_ + 1) * turned({1, 0}, (k + 0.5) * 2 * M_PI / kLooksRound)));
  }

  std::vector<Cell> among(const std::vector<Cell>& obstacles) const {
    std::map<std::size_t, Cell> found;
    if (kShortest * longest_ <= thick_) return {};
    for (const Cell cell : obstacles) {
      if (!isEnd(cell)) continue;
      const std::optional<Leaf> leaf = leafFrom(cell);
      if (!leaf || isInLine(*leaf)) continue;
      if (isBesideDoorway(*leaf, toLeft(leaf->way)) ||
          isBesideDoorway(*leaf, -1 * toLeft(leaf->way)))
        for (const Cell own : leaf->cells) found[grid_.frame.index(own)] = own;
    }
    return mapped(found, [](const auto& each) { return each.second; });
  }

 private:
  bool isSolid(Cell cell) const { return grid_.atOrUnknown(cell) != State::free; }

  /** Whether what is solid round a cell lies in one direction. */
  bool isEnd(Cell cell) const {
    if (!isSolid(cell)) return false;  // it was clutter
    const auto isSolidAt = [&](const Cell& way) {
      return isSolid({cell.x + way.x, cell.y + way.y});
    };
    // Of four directions at right angles a quarter has one.
    int solid = 0, arcs = 0;
    for (int k = 0; k < kLooksRound; k += kLooksRound / 4) solid += isSolidAt(round_[k]) ? 1 : 0;
    if (solid > 1) return false;
    solid = 0;
    bool isBefore = isSolidAt(round_.back());
    for (const Cell& way : round_) {
      const bool isNow = isSolidAt(way);
      solid += isNow ? 1 : 0;
      arcs += isNow && !isBefore ? 1 : 0;
      if (arcs > 1 || 4 * solid > kLooksRound) return false;
      isBefore = isNow;
    }
    return arcs == 1;
  }

  /** What hangs together with a cell, is no farther from it than this [cells], and fits. */
  template <class Fits>
  ClutterGroup connectedWith(Cell cell, double reach, const Fits& fits) const {
    ClutterGroup group;
    const int border = int(reach), side = 2 * border + 1;
    std::vector<char> isIn(std::size_t(side) * side);
    const auto add = [&](Cell c) {
      const int x = c.x - cell.x, y = c.y - cell.y;
      if (x * x + y * y > reach * reach) return;
      char& isKnown = isIn[std::size_t(y + border) * side + x + border];
      if (isKnown || !grid_.frame.contains(c) || !isSolid(c) || !fits(c)) return;
      isKnown = true;
      group.cells.push_back(c);
      group.box.include(c);
    };
    add(cell);
    for (std::size_t i = 0; i < group.cells.size(); ++i) {
      const Cell c = group.cells[i];
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) add({c.x + dx, c.y + dy});
    }
    return group;
  }

  /** Until something stands beside it. None where it is too thick, short or long, or unseen. */
  std::optional<Leaf> leafFrom(Cell cell) const {
    const ClutterGroup part = connectedWith(cell, kShortest * longest_, [](Cell) { return true; });
    Leaf leaf{{}, part.middle(), directionOf(part)};
    leaf.thickness = widthAcross(part, leaf.way);
    if (leaf.thickness > thick_ + 1) return std::nullopt;
    if (leaf.along(cell) > 0) leaf.way = -1 * leaf.way;
    double first = 0;
    for (const Cell own : part.cells) first = std::min(first, leaf.along(own));
    leaf.end = leaf.end + first * leaf.way;
    const auto isNear = [&](Cell c) { return leaf.off(c) < thick_; };
    leaf.cells = connectedWith(cell, longest_ + thick_, isNear).cells;
    leaf.length = 2 * longest_;
    for (const Cell c : leaf.cells)
      if (leaf.off(c) > 0) leaf.length = std::min(leaf.length, leaf.along(c));
    eraseIf(leaf.cells, [&](Cell c) { return leaf.along(c) >= leaf.length || leaf.off(c) > 0; });
    const auto seen = countIf(leaf.cells, [&](Cell c) { return grid_.at(c) == State::occupied; });
    const bool isOne = leaf.length >= kShortest * longest_ && leaf.length <= longest_ + 1;
    return isOne && 2 * seen >= leaf.cells.size() ? std::optional(leaf) : std::nullopt;
  }

  bool isInLine(const Leaf& leaf) const {
    const Point back = -1 * leaf.way;
    return anyOf(kBesideBorders, [&](double side) {
      const Point start = leaf.end + side * toLeft(back);
      const auto wall = acrossGap(grid_, start, back, kWidestGap * longest_);
      return wall && wallGoesOn(grid_, *wall, back, leaf.thickness);
    });
  }

  /** Whether something stands so many cells beside a hinge, between two places along its leaf. */
  bool isOccupied(const Hinge& hinge, int step, double low, double high) const {
    for (int half = int(2 * low); half <= 2 * high; ++half)
      for (const double side : kBesideBorders) {
        const Point place = hinge.place + (step + side) * hinge.out + 0.5 * half * hinge.way;
        if (grid_.atOrUnknown(cellAt(place)) == State::occupied) return true;
      }
    return false;
  }

  /** How far the wall that a leaf hangs at may lie off a right angle with it [cells]. */
  double reach(int step) const { return thick_ + kLean * std::abs(step); }

  bool isWall(const Hinge& hinge, int step) const {
    return isOccupied(hinge, step, -reach(step), reach(step));
  }

  bool goesOn(const Hinge& hinge, int from, int way) const {
    for (int step = 0; step <= thick_; ++step)
      if (!isWall(hinge, from + way * step)) return false;
    return true;
  }

  /** Whether the wall that it hangs at goes on to one side, and to the other, `out`, behind a
   *  doorway, with nothing before it there: that would be the far side of a corridor. */
  bool isBesideDoorway(const Leaf& leaf, Point out) const {
    const Hinge hinge{leaf.end + leaf.length * leaf.way, leaf.way, out};
    int jamb = 1;
    while (jamb <= thick_ + 1 && isWall(hinge, jamb)) ++jamb;
    if (jamb > thick_ + 1 || !goesOn(hinge, -1, -1)) return false;
    int far = jamb;
    while (far <= kWideDoorway * leaf.length && !isWall(hinge, far)) ++far;
    if (far < kNarrowDoorway * leaf.length || far > kWideDoorway * leaf.length ||
        !goesOn(hinge, far, 1))
      return false;
    for (int step = far + 1; step <= far + thick_ + 1; ++step)
      if (isOccupied(hinge, step, -leaf.length, -reach(step) - thick_)) return false;
    return true;
  }

  const Grid& grid_;
  double longest_;  // [cells]
  int thick_;       // how thick the thickest is, with a cell that is ragged
  std::vector<Cell> round_;
};

}  // namespace

std::vector<Cell> findLeaves(const std::vector<Cell>& obstacles, const Grid& grid, double maxSize) {
  return LeafFinder(grid, maxSize).among(obstacles);
}

}  // namespace roomgraph
