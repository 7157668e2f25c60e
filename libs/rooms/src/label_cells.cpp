#include "label_cells.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace roomgraph {
namespace {

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
    for (std::size_t cell = first; cell < first + std::size_t(end - begin); ++cell)
      if (grid.cells[cell] == State::free) labels[cell] = here.right;
  }
  return labels;
}

}  // namespace roomgraph
