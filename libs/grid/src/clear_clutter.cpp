#include "roomgraph/grid/clear_clutter.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

enum class Mark : std::uint8_t { unseen, inGroup, large };

class ClutterFinder {
 public:
  ClutterFinder(Grid& grid, double maxSize)
      : grid_(grid), maxSize_(maxSize), marks_(grid.cells.size(), Mark::unseen) {}

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
    if (size() > maxSize_) return false;
    for (std::size_t i = 0; i < group_.size(); ++i) {
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (!visit({group_[i].x + dx, group_[i].y + dy})) return false;
      countRim(group_[i]);
      wall_ += grid_.at(group_[i]) == State::occupied ? 1 : 0;
    }
    return true;
  }

  bool visit(Cell near) {
    const GridFrame& frame = grid_.frame;
    if (!frame.contains(near)) return false;
    const std::size_t index = frame.index(near);
    if (grid_.cells[index] == State::free || marks_[index] == Mark::inGroup) return true;
    if (marks_[index] == Mark::large) return false;
    add(near);
    return size() <= maxSize_;
  }

  void countRim(Cell cell) {
    const auto isFree = [&](int dx, int dy) {
      return grid_.atOrUnknown({cell.x + dx, cell.y + dy}) == State::free;
    };
    if (!isFree(1, 0) && !isFree(-1, 0) && !isFree(0, 1) && !isFree(0, -1)) return;
    ++rim_;
  }

  void add(Cell cell) {
    marks_[grid_.frame.index(cell)] = Mark::inGroup;
    group_.push_back(cell);
    low_ = {std::min(low_.x, cell.x), std::min(low_.y, cell.y)};
    high_ = {std::max(high_.x, cell.x), std::max(high_.y, cell.y)};
  }

  double size() const {
    return grid_.frame.resolution * std::hypot(high_.x - low_.x + 1, high_.y - low_.y + 1);
  }

  Grid& grid_;
  double maxSize_;
  std::vector<Mark> marks_;
  std::vector<Cell> group_;
  Cell low_, high_;
  std::size_t rim_ = 0, wall_ = 0;  // cells at free ones, and occupied cells
};

}  // namespace

void describe(ClearClutterOptions& options, FieldTable& table) {
  table.number("clear_clutter", "max_size", options.maxSize, "m", 0, 10,
               "Free-standing obstacles whose box has at most this diagonal do not split rooms; 0 "
               "for none.");
}

ClearedMap clearClutter(const Grid& grid, const ObstacleSites& sites,
                        const ClearClutterOptions& options) {
  ClearedMap cleared{grid, std::vector<std::uint8_t>(sites.cells.size()), {}};
  ClutterFinder finder(cleared.grid, options.maxSize);
  for (const Cell cell : sites.cells) finder.clear(cell, cleared.clutter);
  // A site whose cell has become free was clutter.
  for (std::size_t i = 0; i < sites.cells.size(); ++i)
    cleared.isClutter[i] = cleared.grid.atOrUnknown(sites.cells[i]) == State::free;
  return cleared;
}

}  // namespace roomgraph
