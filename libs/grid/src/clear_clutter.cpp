#include "roomgraph/grid/clear_clutter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ClutterGroup.h"
#include "find_furniture.h"
#include "find_leaves.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

/** A table may be this many times as large as other clutter. */
constexpr double kTableSize = 2;
/** Of the square of its size, its area is at least this share: half of it is a square, and two
 *  fifths is a table twice as long as wide. */
constexpr double kTableShare = 0.3;
/** In so many directions one looks from a table for walls; in more than half of them there are
 *  some. */
constexpr int kLooks = 16;
/** A wall goes on for so many times the thickness of the band that it lies in. */
constexpr double kWallShape = 3;
/** Lines through a piece, beside that along it, on which walls are looked for: so many that one of
 *  them meets a thin wall behind a gap. */
constexpr int kLines = 128;

enum class Mark : std::uint8_t { unseen, inGroup, small, other };

class ClutterFinder {
 public:
  ClutterFinder(ClearedMap& cleared, double maxSize)
      : cleared_(cleared),
        grid_(cleared.grid),
        maxSize_(maxSize),
        maxTable_(kTableSize * maxSize),
        maxFurniture_(kLongestFurniture * maxSize),
        marks_(grid_.cells.size(), Mark::unseen) {}

  /** Frees the groups of these cells that are clutter, and tells about them: first what is small,
   *  then all tables among what is left, so that the order of the cells does not matter. What is
   *  furniture, or the leaf of a door, stays. */
  void clear(const std::vector<Cell>& obstacles) {
    std::vector<ClutterGroup> found;
    for (const Cell cell : obstacles) {
      if (!grid_.frame.contains(cell) || marks_[grid_.frame.index(cell)] != Mark::unseen) continue;
      const bool isFound = collect(cell);
      mark(group_, isFound && isSmall(group_) ? Mark::small : Mark::other);
      if (isFound) found.push_back(std::move(group_));
    }
    eraseIf(found,
            [&](const ClutterGroup& group) { return isSmall(group) && isPieceOfWall(group); });
    for (const ClutterGroup& group : found)
      if (isSmall(group)) freeCells(group);
    const auto rest = std::stable_partition(
        found.begin(), found.end(),
        [&](const ClutterGroup& group) { return isSmall(group) || isTable(group); });
    std::vector<ClutterGroup> larger(std::make_move_iterator(rest),
                                     std::make_move_iterator(found.end()));
    found.erase(rest, found.end());
    for (const ClutterGroup& group : found) {
      freeCells(group);
      const GridFrame& frame = grid_.frame;
      if (group.isSeen())
        cleared_.clutter.push_back(
            {midpoint(frame.center(group.box.low), frame.center(group.box.high)),
             frame.resolution * group.size});
    }
    std::vector<Cell>& furniture = cleared_.furniture;
    furniture = findLeaves(obstacles, grid_, maxSize_);
    for (const ClutterGroup& group : furnitureAmong(std::move(larger), grid_, maxSize_))
      furniture.insert(furniture.end(), group.cells.begin(), group.cells.end());
  }

 private:
  void mark(const ClutterGroup& group, Mark as) {
    for (const Cell cell : group.cells) marks_[grid_.frame.index(cell)] = as;
  }

  void freeCells(const ClutterGroup& group) {
    for (const Cell cell : group.cells) grid_.cells[grid_.frame.index(cell)] = State::free;
  }

  /** Fills group_, and gives up where it is too large, or touches the border or a large one. */
  bool collect(Cell first) {
    group_.cells.clear();  // which keeps their memory
    group_.box = {};
    group_.rim = group_.wall = 0;
    add(first);
    // The last one first: what is large is left on the shortest way.
    for (open_ = {first}; !open_.empty();) {
      const Cell cell = open_.back();
      open_.pop_back();
      if (isAtBorder(cell)) return false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (!visit({cell.x + dx, cell.y + dy})) return false;
      group_.rim += grid_.countBeside(cell, State::free) > 0 ? 1 : 0;
      group_.wall += grid_.at(cell) == State::occupied ? 1 : 0;
    }
    group_.size = sizeOf(group_);
    return metres(group_.size) <= maxFurniture_;
  }

  double metres(double cells) const { return grid_.frame.resolution * cells; }

  bool isSmall(const ClutterGroup& group) const { return metres(group.size) <= maxSize_; }

  /** Whether it fills a part of a gap between two walls that are in line with it, as do the pier
   *  between two doors and the posts of a glass front. Not what stands in a single door. */
  bool isPieceOfWall(const ClutterGroup& group) const {
    if (!group.isSeen()) return false;
    const auto isInLine = [&](Point start, Point direction) {
      const auto stepsTo = [&](Point way) {
        return stepsToObstacle(start, way, Mark::small, maxSize_);
      };
      const auto ahead = stepsTo(direction), behind = ahead ? stepsTo(-1 * direction) : ahead;
      if (!behind || metres(*ahead + *behind - 1) <= maxSize_) return false;
      const int one = thicknessAt(start + double(*ahead) * direction, direction);
      const int other =
          one > 0 ? thicknessAt(start - double(*behind) * direction, -1 * direction) : 0;
      return other > 0 && 2 * widthAcross(group, direction) >= std::max(one, other);
    };
    const Point middle = group.middle(), along = directionOf(group);
    // Where the middle lies between two rows, one on either side of it.
    for (const double side : {-0.25, 0.25})
      if (isInLine(middle + side * turned(along, M_PI / 2), along)) return true;
    for (int k = 0; k < kLines; ++k)
      if (isInLine(middle, turned({1, 0}, (k + 0.5) * M_PI / kLines))) return true;
    return false;
  }

  /** How many steps it is to the first obstacle in a direction but for those with a mark, if no gap
   *  on the way is wider [m]. */
  std::optional<int> stepsToObstacle(Point from, Point direction, Mark passed,
                                     double widest) const {
    int gap = 0;  // cells
    for (int step = 1; metres(gap) <= widest; ++step) {
      const Cell c = cellAt(from + double(step) * direction);
      if (!grid_.frame.contains(c)) break;
      if (grid_.at(c) == State::free)
        ++gap;
      else if (marks_[grid_.frame.index(c)] == passed)
        gap = 0;
      else
        return step;
    }
    return std::nullopt;
  }

  /** Of a wall that begins at a place and goes on in a direction [cells]; 0 where none does, but
   *  something stands there across it, or as large. A ragged or slanted one goes on in a band that
   *  is a cell wider on either side. */
  int thicknessAt(Point place, Point direction) const {
    const Point across = toLeft(direction);
    const int length = 1 + run([&](int step) {
                         const Point on = place + double(step) * direction;
                         return isSolid(on) || isSolid(on + across) || isSolid(on - across);
                       });
    const auto thicknessOf = [&](Point inside) {
      return 1 + run([&](int step) { return isSolid(inside + double(step) * across); }) +
             run([&](int step) { return isSolid(inside - double(step) * across); });
    };
    const int half = length / 2;
    const int thickness =
        std::max(thicknessOf(place), thicknessOf(place + double(half) * direction));
    return kWallShape * (thickness + 2) <= length ? thickness : 0;
  }

  /** How many steps something is there from the first one on, as far as a wall is followed. */
  template <class IsThere>
  int run(const IsThere& isThere) const {
    const int most = int(maxSize_ / grid_.frame.resolution);
    int count = 0;
    while (count < most && isThere(count + 1)) ++count;
    return count;
  }

  bool isSolid(Point place) const {
    const Cell cell = cellAt(place);
    return grid_.atOrUnknown(cell) != State::free &&
           (!grid_.frame.contains(cell) || marks_[grid_.frame.index(cell)] != Mark::small);
  }

  /** Whether it has a room round it, which may be larger where nothing else is near. What stands in
   *  a hall splits nothing, and a row of cupboards with doors between them has space on two sides:
   *  both stay. */
  bool isTable(const ClutterGroup& group) {
    if (metres(group.size) > maxTable_ ||
        double(group.cells.size()) < kTableShare * group.size * group.size)
      return false;
    mark(group, Mark::inGroup);
    const bool isAlone = looksToObstacles(group, maxSize_) == 0;
    const int walls = looksToObstacles(group, isAlone ? 2 * maxTable_ : maxTable_);
    mark(group, Mark::other);
    return 2 * walls > kLooks;
  }

  /** In how many directions something stands within so much free space of a group. */
  int looksToObstacles(const ClutterGroup& group, double widest) const {
    int count = 0;
    for (int k = 0; k < kLooks; ++k) {  // never along an axis, where cells could tie
      const Point direction = turned({1, 0}, (k + 0.5) * 2 * M_PI / kLooks);
      count += stepsToObstacle(group.middle(), direction, Mark::inGroup, widest).has_value();
    }
    return count;
  }

  bool isAtBorder(Cell cell) const {
    return !grid_.frame.contains({cell.x - 1, cell.y - 1}) ||
           !grid_.frame.contains({cell.x + 1, cell.y + 1});
  }

  bool visit(Cell near) {
    const std::size_t index = grid_.frame.index(near);
    if (grid_.cells[index] == State::free || marks_[index] == Mark::inGroup) return true;
    if (marks_[index] == Mark::other) return false;
    open_.push_back(near);
    return !add(near) || metres(std::max(group_.box.width(), group_.box.height())) <= maxFurniture_;
  }

  /** Returns whether the box of the group has grown. */
  bool add(Cell cell) {
    marks_[grid_.frame.index(cell)] = Mark::inGroup;
    group_.cells.push_back(cell);
    const bool isWithin = group_.box.contains(cell);
    group_.box.include(cell);
    return !isWithin;
  }

  ClearedMap& cleared_;
  Grid& grid_;                                // of it
  double maxSize_, maxTable_, maxFurniture_;  // [m]
  std::vector<Mark> marks_;
  ClutterGroup group_;
  std::vector<Cell> open_;  // of it, whose neighbours are not visited yet
};

/** An obstacle whose cell has become free was clutter. */
void markClutter(ClearedMap& cleared, const ObstacleCells& obstacles) {
  for (std::size_t i = 0; i < obstacles.cells.size(); ++i)
    cleared.isClutter[i] = cleared.grid.atOrUnknown(obstacles.cells[i]) == State::free;
}

}  // namespace

void describe(ClearClutterOptions& options, FieldTable& table) {
  table.number(
      "clear_clutter", "max_size", options.maxSize, "m", 0, 10,
      "Free-standing obstacles up to this size do not split rooms; nor do compact ones up to twice "
      "this size with walls near on most sides, such as tables, nor solid ones up to twice as wide "
      "and five times as long with space all round, such as shelves, nor leaves of open doors up "
      "to this length. An obstacle in line with walls, such as the pier between two doors, counts "
      "as wall. 0 keeps all obstacles.");
}

ClearedMap clearClutter(const Grid& grid, const ObstacleCells& obstacles,
                        const ClearClutterOptions& options) {
  ClearedMap cleared{grid, std::vector<std::uint8_t>(obstacles.cells.size()), {}, {}};
  ClutterFinder(cleared, options.maxSize).clear(obstacles.cells);
  markClutter(cleared, obstacles);
  return cleared;
}

ClearedMap withoutFurniture(ClearedMap cleared, const ObstacleCells& obstacles) {
  const GridFrame& frame = cleared.grid.frame;
  for (const Cell cell : cleared.furniture) cleared.grid.cells[frame.index(cell)] = State::free;
  markClutter(cleared, obstacles);
  return cleared;
}

}  // namespace roomgraph
