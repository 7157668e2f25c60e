#include "label_areas.h"

#include <algorithm>
#include <limits>

namespace roomgraph {
namespace {

using Label = std::uint16_t;
constexpr Label kNoLabel = 0;
/** Free, and open to be filled from its neighbours; becomes kNoLabel where none reaches it. */
constexpr Label kUnlabelled = std::numeric_limits<Label>::max();

/** From here on to the right the cells of a row have this label. */
struct Crossing {
  float x;  // in cells, 0 at the centre of the first
  Label right;
};

/** Fills the Delaunay faces with the labels of their areas, row by row. */
class FaceFiller {
 public:
  FaceFiller(const ClearedSpace& space, const std::vector<AreaId>& areaOf)
      : space_(space), areaOf_(areaOf), rows_(std::size_t(space.grid.frame.height)) {
    for (const VoronoiEdge& edge : space.voronoi.edges) addEdge(edge);
  }

  std::vector<Label> run() {
    const GridFrame& frame = space_.grid.frame;
    std::vector<Label> labels(frame.cellCount(), kNoLabel);
    for (int y = 0; y < frame.height; ++y) fillRow(y, &labels[frame.index({0, y})]);
    return labels;
  }

 private:
  Label labelOf(std::uint32_t vertex) const {
    if (vertex == VoronoiEdge::kNoVertex) return kNoLabel;
    if (space_.isInside[vertex]) {
      const AreaId area = areaOf_[space_.regions.of(vertex)];
      // Too many areas for 16 bits: those beyond have no label.
      return area && area.index() + 1 < kUnlabelled ? Label(area.index() + 1) : kNoLabel;
    }
    // A face of the inside whose centre lies in a wall or in the unknown is open; outside is not.
    return space_.grid.isFree(space_.voronoi.vertices[vertex].at) ? kNoLabel : kUnlabelled;
  }

  /** Sites are centres of cells, so rows meet them exactly. */
  void addEdge(const VoronoiEdge& edge) {
    const Label ofSource = labelOf(edge.source), ofTarget = labelOf(edge.target);
    if (ofSource == ofTarget) return;
    const GridFrame& frame = space_.grid.frame;
    const Point p = space_.voronoi.sites[edge.right], q = space_.voronoi.sites[edge.left];
    const int yP = frame.cellAt(p).y, yQ = frame.cellAt(q).y;
    // The source lies on the left of the way from the right site to the left one.
    const Label right = yQ > yP ? ofTarget : ofSource;
    const double xP = (p.x - frame.origin.x) / frame.resolution - 0.5;
    const double slope = yP == yQ ? 0 : (q.x - p.x) / frame.resolution / (yQ - yP);
    for (int y = std::min(yP, yQ); y < std::max(yP, yQ); ++y)
      if (y >= 0 && y < frame.height)
        rows_[std::size_t(y)].push_back({float(xP + slope * (y - yP)), right});
  }

  void fillRow(int y, Label* labels) {
    constexpr float kOnLine = 1e-3f;  // in cells: a centre on the line is right of it
    std::vector<Crossing>& row = rows_[std::size_t(y)];
    std::stable_sort(row.begin(), row.end(),
                     [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    Label label = kNoLabel;
    std::size_t next = 0;
    for (int x = 0; x < space_.grid.frame.width; ++x) {
      while (next < row.size() && row[next].x <= float(x) + kOnLine) label = row[next++].right;
      labels[x] = label;
    }
  }

  const ClearedSpace& space_;
  const std::vector<AreaId>& areaOf_;
  std::vector<std::vector<Crossing>> rows_;
};

/** Gives unlabelled cells the label of the nearest cell that has one, by way of cells that share a
 *  side. */
void spreadLabels(const GridFrame& frame, std::vector<Label>& labels) {
  const auto isLabel = [](Label label) { return label != kNoLabel && label != kUnlabelled; };
  std::vector<std::uint32_t> front, next;
  const auto visitNeighbours = [&](std::uint32_t cell, const auto& visit) {
    const auto width = std::uint32_t(frame.width);
    const std::uint32_t x = cell % width;
    if (x > 0) visit(cell - 1);
    if (x + 1 < width) visit(cell + 1);
    if (cell >= width) visit(cell - width);
    if (cell + width < labels.size()) visit(cell + width);
  };
  for (std::uint32_t cell = 0; cell < labels.size(); ++cell) {
    if (!isLabel(labels[cell])) continue;
    bool isAtEdge = false;
    visitNeighbours(cell, [&](std::uint32_t n) { isAtEdge |= labels[n] == kUnlabelled; });
    if (isAtEdge) front.push_back(cell);
  }
  for (; !front.empty(); front.swap(next)) {
    next.clear();
    for (const std::uint32_t cell : front)
      visitNeighbours(cell, [&](std::uint32_t n) {
        if (labels[n] != kUnlabelled) return;
        labels[n] = labels[cell];
        next.push_back(n);
      });
  }
  std::replace(labels.begin(), labels.end(), kUnlabelled, kNoLabel);
}

}  // namespace

std::vector<std::uint16_t> labelAreas(const ClearedSpace& space,
                                      const std::vector<AreaId>& areaOf) {
  std::vector<Label> labels = FaceFiller(space, areaOf).run();
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (space.grid.cells[i] != State::free) labels[i] = kNoLabel;
  spreadLabels(space.grid.frame, labels);
  return labels;
}

}  // namespace roomgraph
