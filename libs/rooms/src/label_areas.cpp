#include "label_areas.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {
namespace {

/** One region at least of each connected part of the graph. */
std::vector<std::uint32_t> seeds(const RegionOutlines& outlines, const RoomGraph& graph) {
  const auto& vertices = graph.graph.vertices();
  UnionFind parts(vertices.size());
  for (const Edge& edge : graph.graph.edges()) parts.join(edge.source.index(), edge.target.index());
  std::vector<std::uint8_t> isFound(vertices.size());
  std::vector<std::uint32_t> found;
  for (const GraphRoom& room : graph.rooms) {
    found.push_back(room.shape.region);
    isFound[parts.find(room.vertex.index())] = 1;
  }
  const auto isMissing = [&](std::uint32_t v) { return !isFound[parts.find(v)]; };
  std::vector<std::uint32_t> missing;
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (isMissing(v)) missing.push_back(v);
  if (missing.empty()) return found;
  const RoomIndex index(outlines.regions);
  for (const std::uint32_t v : missing) {
    const RoomId region = isMissing(v) ? index.roomAt(vertices[v].place) : RoomId::none();
    if (!region) continue;  // on a line between two
    found.push_back(std::uint32_t(region.index()));
    isFound[parts.find(v)] = 1;
  }
  return found;
}

using Label = std::uint16_t;

/** From here on to the right the cells of a row have another label. */
struct Crossing {
  int row;
  double x;      // in cells, 0 at the centre of the first
  double slope;  // of the border, x by y: borders that share their lower end part in this order
  Label right;

  /** The first cell that is not left of it; one with its centre on the line is right of it. */
  int column() const { return std::max(0, int(std::ceil(x - 1e-6))); }
};

/** Areas beyond those that 16 bits can tell apart have no label. */
Label labelOf(std::uint32_t region, const std::vector<AreaId>& areaOf) {
  const AreaId area = region == Regions::kNone ? AreaId::none() : areaOf[region];
  return area && area.index() < kMaxLabelledAreas ? Label(area.index() + 1) : Label(0);
}

/** Where a border meets the rows of the grid. Its ends are centres of cells, so rows meet these
 *  exactly: the lower end counts, the upper one does not. */
void addCrossings(const GridFrame& frame, const RegionBorder& border, Label left, Label right,
                  std::vector<Crossing>& crossings) {
  const Cell from = frame.cellAt(border.from), to = frame.cellAt(border.to);
  if (from.y == to.y) return;
  const double slope = double(to.x - from.x) / (to.y - from.y);
  const Label rightHand = to.y > from.y ? right : left;
  const Cell low = from.y < to.y ? from : to;
  const int last = std::min(std::max(from.y, to.y), frame.height);
  for (int row = std::max(0, low.y); row < last; ++row)
    crossings.push_back({row, low.x + slope * (row - low.y), slope, rightHand});
}

}  // namespace

std::vector<std::uint8_t> reachedRegions(const RegionOutlines& outlines, const RoomGraph& graph,
                                         double clearance) {
  const std::size_t count = outlines.regions.size();
  // A room that is not in the graph is not reached, nor what lies behind it.
  std::vector<std::uint8_t> isOpen(count, 1);
  std::fill_n(isOpen.begin(), outlines.roomCount, std::uint8_t(0));
  for (const GraphRoom& room : graph.rooms) isOpen[room.shape.region] = 1;
  std::fill(isOpen.begin() + outlines.seenCount, isOpen.end(), std::uint8_t(0));

  UnionFind parts(count);
  for (const RegionBorder& border : outlines.borders)
    if (isPassage(border, clearance) && isOpen[border.left] && isOpen[border.right])
      parts.join(border.left, border.right);
  std::vector<std::uint8_t> isReachedPart(count), isReached(count);
  for (const std::uint32_t region : seeds(outlines, graph)) isReachedPart[parts.find(region)] = 1;
  for (std::uint32_t r = 0; r < count; ++r)
    isReached[r] = isOpen[r] && isReachedPart[parts.find(r)];
  return isReached;
}

std::vector<std::uint16_t> labelCells(const Grid& grid, const std::vector<RegionBorder>& borders,
                                      const std::vector<AreaId>& areaOf) {
  const GridFrame& frame = grid.frame;
  std::vector<Crossing> crossings;
  for (const RegionBorder& border : borders) {
    const Label left = labelOf(border.left, areaOf), right = labelOf(border.right, areaOf);
    if (left != right) addCrossings(frame, border, left, right, crossings);
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.row, a.x, a.slope) < std::tie(b.row, b.x, b.slope);
  });
  std::vector<Label> labels(frame.cellCount());
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Crossing& here = crossings[i];
    const bool isLast = i + 1 == crossings.size() || crossings[i + 1].row != here.row;
    const int begin = here.column();
    const int end = isLast ? frame.width : std::min(crossings[i + 1].column(), frame.width);
    if (here.right == 0 || begin >= end) continue;
    const std::size_t first = frame.index({begin, here.row});
    // No branch within, so that the compiler takes many cells at once.
    for (std::size_t cell = first; cell < first + std::size_t(end - begin); ++cell)
      labels[cell] = grid.cells[cell] == State::free ? here.right : Label(0);
  }
  return labels;
}

}  // namespace roomgraph
