#include "roomgraph/grid/clear_clutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/CellBox.h"

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

enum class Mark : std::uint8_t { unseen, inGroup, other };

/** Connected cells that are not free. */
struct Group {
  std::vector<Cell> cells;
  CellBox box;
  std::size_t rim = 0, wall = 0;  // cells at free ones, and occupied cells
};

class ClutterFinder {
 public:
  ClutterFinder(Grid& grid, double maxSize)
      : grid_(grid),
        maxSize_(maxSize),
        maxTable_(kTableSize * maxSize),
        marks_(grid.cells.size(), Mark::unseen) {}

  /** Frees the groups of these cells that are clutter, and tells about them: first what is small,
   *  then all tables among what is left, so that the order of the cells does not matter. */
  std::vector<Clutter> clear(const std::vector<Cell>& obstacles) {
    std::vector<Group> found;
    for (const Cell cell : obstacles) {
      if (!grid_.frame.contains(cell) || marks_[grid_.frame.index(cell)] != Mark::unseen) continue;
      const bool isFound = collect(cell);
      mark(group_, Mark::other);
      if (!isFound) continue;
      if (isSmall(group_)) freeCells(group_);
      found.push_back(std::move(group_));
    }
    const auto stays = [&](const Group& group) { return !isSmall(group) && !isTable(group); };
    found.erase(std::remove_if(found.begin(), found.end(), stays), found.end());
    std::vector<Clutter> clutter;
    for (const Group& group : found) {
      freeCells(group);
      const GridFrame& frame = grid_.frame;
      if (2 * group.wall >= group.rim)
        clutter.push_back(
            {midpoint(frame.center(group.box.low), frame.center(group.box.high)), sizeOf(group)});
    }
    return clutter;
  }

 private:
  void mark(const Group& group, Mark as) {
    for (const Cell cell : group.cells) marks_[grid_.frame.index(cell)] = as;
  }

  void freeCells(const Group& group) {
    for (const Cell cell : group.cells) grid_.cells[grid_.frame.index(cell)] = State::free;
  }

  /** Fills group_, and gives up where it is too large, or touches the border or a large one. */
  bool collect(Cell first) {
    group_.cells.clear();  // which keeps their memory
    group_.box = {};
    group_.rim = group_.wall = 0;
    add(first);
    if (sizeOf(group_) > maxTable_) return false;
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
    return isSmall(group_) || isCompact(group_);
  }

  bool isSmall(const Group& group) const { return sizeOf(group) <= maxSize_; }

  bool isCompact(const Group& group) const {
    const double cell = grid_.frame.resolution, size = sizeOf(group);
    return double(group.cells.size()) * cell * cell >= kTableShare * size * size;
  }

  /** Whether it has a room round it. What stands in a hall splits nothing, and a row of cupboards
   *  with doors between them has space on two sides: both stay. */
  bool isTable(const Group& group) {
    mark(group, Mark::inGroup);
    const Point middle = 0.5 * Point{double(group.box.low.x + group.box.high.x),
                                     double(group.box.low.y + group.box.high.y)};
    int walls = 0;
    for (int k = 0; k < kLooks; ++k)  // never along an axis, where cells could tie
      walls += hasWallFrom(middle, turned({1, 0}, (k + 0.5) * 2 * M_PI / kLooks)) ? 1 : 0;
    mark(group, Mark::other);
    return 2 * walls > kLooks;
  }

  /** Whether another obstacle is no farther from the rim of the group round `middle` [cells] than
   *  the largest table is long. */
  bool hasWallFrom(Point middle, Point direction) const {
    const GridFrame& frame = grid_.frame;
    int gap = 0;  // cells behind the rim
    for (int step = 1; gap * frame.resolution <= maxTable_; ++step) {
      const Point place = middle + double(step) * direction;
      const Cell c{int(std::lround(place.x)), int(std::lround(place.y))};
      if (!frame.contains(c)) return false;
      if (grid_.at(c) == State::free)
        ++gap;
      else if (marks_[frame.index(c)] == Mark::inGroup)
        gap = 0;
      else
        return true;
    }
    return false;
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
    return !add(near) || sizeOf(group_) <= maxTable_;
  }

  /** Returns whether the box of the group has grown. */
  bool add(Cell cell) {
    marks_[grid_.frame.index(cell)] = Mark::inGroup;
    group_.cells.push_back(cell);
    const bool isWithin = group_.box.contains(cell);
    group_.box.include(cell);
    return !isWithin;
  }

  double sizeOf(const Group& group) const {
    return grid_.frame.resolution * norm({double(group.box.width()), double(group.box.height())});
  }

  Grid& grid_;
  double maxSize_, maxTable_;  // [m]
  std::vector<Mark> marks_;
  Group group_;
  std::vector<Cell> open_;  // of it, whose neighbours are not visited yet
};

}  // namespace

void describe(ClearClutterOptions& options, FieldTable& table) {
  table.number(
      "clear_clutter", "max_size", options.maxSize, "m", 0, 10,
      "Free-standing obstacles whose box has at most this diagonal do not split rooms, nor "
      "do compact ones up to twice that with a room round them, as tables; 0 for none.");
}

ClearedMap clearClutter(const Grid& grid, const ObstacleCells& obstacles,
                        const ClearClutterOptions& options) {
  ClearedMap cleared{grid, std::vector<std::uint8_t>(obstacles.cells.size()), {}};
  cleared.clutter = ClutterFinder(cleared.grid, options.maxSize).clear(obstacles.cells);
  // An obstacle whose cell has become free was clutter.
  for (std::size_t i = 0; i < obstacles.cells.size(); ++i)
    cleared.isClutter[i] = cleared.grid.atOrUnknown(obstacles.cells[i]) == State::free;
  return cleared;
}

}  // namespace roomgraph
