#include "roomgraph/align/shared_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

constexpr double kFewestEdges = 100;  // cells below which nothing is told

// Of the edge cells of one and of the other map. Of edits of one picture, one has nearly all that
// the other has kept, which may be a third; two drives share a fifth.
constexpr double kMostShared = 0.7, kLeastShared = 0.3;

/** Whole turns and shifts of cells: a <- b. */
struct CellMotion {
  int cosine = 1, sine = 0;
  Cell shift;

  Cell operator()(Cell c) const {
    return {cosine * c.x - sine * c.y + shift.x, sine * c.x + cosine * c.y + shift.y};
  }
  CellMotion shifted(int x, int y) const { return {cosine, sine, {shift.x + x, shift.y + y}}; }
  CellMotion inverse() const {
    return {cosine, -sine, {-cosine * shift.x - sine * shift.y, sine * shift.x - cosine * shift.y}};
  }
};

/** That which carries the middle of b's cells as the pose does; none for a turn that is no quarter
 *  turn. */
std::optional<CellMotion> cellMotion(const DrawnEdges& a, const DrawnEdges& b,
                                     const Transform2D& pose) {
  const long quarters = std::lround(pose.phi / M_PI_2);
  if (std::abs(pose.phi - double(quarters) * M_PI_2) > kSameStart.turn) return {};
  CellMotion motion;
  motion.cosine = int(std::lround(std::cos(double(quarters) * M_PI_2)));
  motion.sine = int(std::lround(std::sin(double(quarters) * M_PI_2)));
  const Cell middle{b.frame.width / 2, b.frame.height / 2};
  const Cell to = a.frame.cellAt(pose(b.frame.center(middle))), turned = motion(middle);
  motion.shift = {to.x - turned.x, to.y - turned.y};
  return motion;
}

/** The cells of some edges that are edges. */
std::vector<Cell> edgeCells(const DrawnEdges& edges) {
  return edges.frame.cellsWhere([&](Cell c) { return edges.isEdge[edges.frame.index(c)] != 0; });
}

struct Count {
  double inside = 0, same = 0;  // cells that lie in the frame of the other map, and on edges there
};

Count countIn(const DrawnEdges& in, const std::vector<Cell>& cells, const CellMotion& motion) {
  Count count;
  for (const Cell& cell : cells) {
    const Cell there = motion(cell);
    if (!in.frame.contains(there)) continue;
    ++count.inside;
    count.same += in.isEdge[in.frame.index(there)] ? 1 : 0;
  }
  return count;
}

}  // namespace

SharedEdges sharedEdges(const DrawnEdges& a, const DrawnEdges& b,
                        const std::vector<Transform2D>& poses) {
  const double cell = a.frame.resolution;
  if (a.isEdge.empty() || b.isEdge.empty()) return {};
  // By less, the far end of a map stays in place.
  if (std::abs(b.frame.resolution - cell) > 1e-4 * cell) return {};
  const std::vector<Cell> ofA = edgeCells(a), ofB = edgeCells(b);
  const int reach = std::max(1, int(std::ceil(kWallNoise / 2 / cell)));
  std::optional<CellMotion> best;
  Count inA;
  for (const Transform2D& pose : poses) {
    const auto near = cellMotion(a, b, pose);
    for (int y = near ? -reach : reach + 1; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const Count count = countIn(a, ofB, near->shifted(x, y));
        if (!best || count.same > inA.same) best = near->shifted(x, y), inA = count;
      }
  }
  if (!best) return {};
  const Count inB = countIn(b, ofA, best->inverse());
  if (inA.inside < kFewestEdges || inB.inside < kFewestEdges) return {};
  return {inB.same / inB.inside, inA.same / inA.inside};
}

bool areEdits(const DrawnEdges& a, const DrawnEdges& b, const std::vector<Transform2D>& poses) {
  const SharedEdges shared = sharedEdges(a, b, poses);
  return std::max(shared.ofA, shared.ofB) >= kMostShared &&
         std::min(shared.ofA, shared.ofB) >= kLeastShared;
}

bool areIdentical(const WallMap& l, const WallMap& r) {
  return l.states == r.states && l.walls.size() == r.walls.size() &&
         std::equal(l.walls.begin(), l.walls.end(), r.walls.begin(),
                    [](const WallPoint& p, const WallPoint& q) { return p.place == q.place; });
}

}  // namespace roomgraph
