#include "drawn_drive.h"

#include <algorithm>
#include <cmath>

namespace roomgraph::test {
namespace {

struct Row {
  int y = 0, from = 0, to = 0;
};

/** The longest free row; of several beside each other the middle one, so that the robot does not
 *  scrape along a wall, where half of its beams would meet what is at its feet. */
Row longestRow(const Grid& grid) {
  Row best;
  int last = 0;  // of the rows from `best` on that are as long
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0, from = 0; x < grid.frame.width; ++x) {
      if (grid.at({x, y}) != State::free) from = x + 1;
      if (x + 1 - from > best.to - best.from) best = {y, from, x + 1}, last = y;
      if (from == best.from && x + 1 == best.to && y == last + 1) last = y;
    }
  best.y = (best.y + last) / 2;
  return best;
}

Keyframe seenFrom(const Grid& grid, const Transform2D& pose) {
  Keyframe frame;
  frame.pose = pose;
  constexpr int beams = 540;
  for (int i = 0; i < beams; ++i) {
    const double angle = M_PI / 360 * (i - beams / 2);
    const Point way = {std::cos(angle), std::sin(angle)};
    double range = 0.1;
    while (range < 15 && grid.atOrUnknown(grid.frame.cellAt(pose(range * way))) == State::free)
      range += 0.01;
    if (grid.atOrUnknown(grid.frame.cellAt(pose(range * way))) == State::occupied)
      frame.ends.push_back(range * way);
  }
  return frame;
}

}  // namespace

std::vector<Keyframe> drawnDrive(const Grid& grid) {
  const Row row = longestRow(grid);
  std::vector<Transform2D> poses;
  const int step = int(0.5 / grid.frame.resolution);
  for (int x = row.from + step; x + step < row.to; x += step) {
    const Point at = grid.frame.center({x, row.y});
    poses.push_back({at.x, at.y, 0});
  }
  return drawnDrive(grid, poses);
}

std::vector<Keyframe> drawnDrive(const Grid& grid, const std::vector<Transform2D>& poses) {
  std::vector<Keyframe> frames;
  for (const Transform2D& pose : poses) {
    frames.push_back(seenFrom(grid, pose));
    frames.back().number = frames.size() - 1;
  }
  return frames;
}

std::vector<Keyframe> broken(std::vector<Keyframe> frames, std::size_t from, double turn,
                             Point shift) {
  const Point at = frames[from].pose.shift();
  const Transform2D motion = carrying(at, at + shift, turn);
  for (std::size_t i = from; i < frames.size(); ++i) frames[i].pose = motion * frames[i].pose;
  return frames;
}

std::vector<Keyframe> drifting(std::vector<Keyframe> frames, double turn) {
  for (std::size_t i = 1; i < frames.size(); ++i) frames = broken(frames, i, turn, {});
  return frames;
}

std::vector<Keyframe> moved(std::vector<Keyframe> frames, const Transform2D& motion) {
  for (Keyframe& frame : frames) frame.pose = motion * frame.pose;
  return frames;
}

Grid mapDrawnBy(const std::vector<Keyframe>& frames) {
  constexpr double cell = 0.05, margin = 1;
  Point low = frames.front().pose.shift(), high = low;
  for (const Keyframe& frame : frames)
    for (const Point end : frame.ends) {
      const Point p = frame.pose(end);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  low = low - Point{margin, margin}, high = high + Point{margin, margin};
  Grid grid;
  grid.frame = {int((high.x - low.x) / cell) + 1, int((high.y - low.y) / cell) + 1, cell, low};
  grid.cells.assign(grid.frame.cellCount(), State::unknown);
  const auto set = [&](Point p, State state) {
    grid.cells[grid.frame.index(grid.frame.cellAt(p))] = state;
  };
  for (const Keyframe& frame : frames)
    for (const Point end : frame.ends)
      for (double part = 0; part < 1; part += cell / (1 + norm(end)))
        set(frame.pose(part * end), State::free);
  for (const Keyframe& frame : frames)
    for (const Point end : frame.ends) set(frame.pose(end), State::occupied);
  return grid;
}

}  // namespace roomgraph::test
