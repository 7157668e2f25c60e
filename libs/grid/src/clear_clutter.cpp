#include "roomgraph/grid/clear_clutter.h"

#include <algorithm>
#include <cmath>

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

enum class Mark : std::uint8_t { unseen, inGroup, large };

class ClutterFinder {
 public:
  ClutterFinder(Grid& grid, double maxSize)
      : grid_(grid),
        maxSize_(maxSize),
        maxTable_(kTableSize * maxSize),
        marks_(grid.cells.size(), Mark::unseen) {}

  /** Frees the group of `first` if it is clutter, and tells about it. */
  void clear(Cell first, std::vector<Clutter>& found) {
    const GridFrame& frame = grid_.frame;
    if (!frame.contains(first) || marks_[frame.index(first)] != Mark::unseen) return;
    if (!collect(first)) {
      for (const Cell c : group_) marks_[frame.index(c)] = Mark::large;
      return;
    }
    for (const Cell c : group_) grid_.cells[frame.index(c)] = State::free;
    if (2 * wall_ >= rim_)
      found.push_back({midpoint(frame.center(low_), frame.center(high_)), size()});
  }

 private:
  /** Fills group_, and gives up where it is too large, or touches the border or a large one. */
  bool collect(Cell first) {
    group_.clear();
    rim_ = wall_ = 0;
    low_ = high_ = first;
    add(first);
    if (size() > maxTable_) return false;
    for (std::size_t i = 0; i < group_.size(); ++i) {
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (!visit({group_[i].x + dx, group_[i].y + dy})) return false;
      countRim(group_[i]);
      wall_ += grid_.at(group_[i]) == State::occupied ? 1 : 0;
    }
    return size() <= maxSize_ || isTable();
  }

  /** Whether it is compact, and has a room round it. What stands in a hall splits nothing, and a
   *  row of cupboards with doors between them has space on two sides: both stay. */
  bool isTable() const {
    const double cell = grid_.frame.resolution;
    if (double(group_.size()) * cell * cell < kTableShare * size() * size()) return false;
    int walls = 0;
    for (int k = 0; k < kLooks; ++k)  // never along an axis, where cells could tie
      walls += hasWallTowards(turned({1, 0}, (k + 0.5) * 2 * M_PI / kLooks)) ? 1 : 0;
    return 2 * walls > kLooks;
  }

  /** Whether another obstacle is no farther from its rim than the largest table is long. */
  bool hasWallTowards(Point direction) const {
    const GridFrame& frame = grid_.frame;
    const Point middle = 0.5 * Point{double(low_.x + high_.x), double(low_.y + high_.y)};
    int gap = 0;  // cells behind the rim
    for (int step = 1; gap * frame.resolution <= maxTable_; ++step) {
      const Point at = middle + double(step) * direction;
      const Cell c{int(std::lround(at.x)), int(std::lround(at.y))};
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

  bool visit(Cell near) {
    const GridFrame& frame = grid_.frame;
    if (!frame.contains(near)) return false;
    const std::size_t index = frame.index(near);
    if (grid_.cells[index] == State::free || marks_[index] == Mark::inGroup) return true;
    if (marks_[index] == Mark::large) return false;
    return !add(near) || size() <= maxTable_;
  }

  void countRim(Cell cell) {
    const auto isFree = [&](int dx, int dy) {
      return grid_.atOrUnknown({cell.x + dx, cell.y + dy}) == State::free;
    };
    if (!isFree(1, 0) && !isFree(-1, 0) && !isFree(0, 1) && !isFree(0, -1)) return;
    ++rim_;
  }

  /** Returns whether the box of the group has grown. */
  bool add(Cell cell) {
    marks_[grid_.frame.index(cell)] = Mark::inGroup;
    group_.push_back(cell);
    const bool isWithin =
        cell.x >= low_.x && cell.x <= high_.x && cell.y >= low_.y && cell.y <= high_.y;
    low_ = {std::min(low_.x, cell.x), std::min(low_.y, cell.y)};
    high_ = {std::max(high_.x, cell.x), std::max(high_.y, cell.y)};
    return !isWithin;
  }

  double size() const {
    return grid_.frame.resolution * std::hypot(high_.x - low_.x + 1, high_.y - low_.y + 1);
  }

  Grid& grid_;
  double maxSize_, maxTable_;  // [m]
  std::vector<Mark> marks_;
  std::vector<Cell> group_;
  Cell low_, high_;
  std::size_t rim_ = 0, wall_ = 0;  // cells at free ones, and occupied cells
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
  ClutterFinder finder(cleared.grid, options.maxSize);
  for (const Cell cell : obstacles.cells) finder.clear(cell, cleared.clutter);
  // An obstacle whose cell has become free was clutter.
  for (std::size_t i = 0; i < obstacles.cells.size(); ++i)
    cleared.isClutter[i] = cleared.grid.atOrUnknown(obstacles.cells[i]) == State::free;
  return cleared;
}

}  // namespace roomgraph
