#pragma once
#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** The grey levels that drawn maps use. The ones of noise tell what the cell was before. */
namespace grey {
constexpr std::uint8_t kWall = 20;
constexpr std::uint8_t kFree = 235;
constexpr std::uint8_t kUnknown = 128;
constexpr std::uint8_t kAddedWall = 60;       ///< was free
constexpr std::uint8_t kMissingWall = 190;    ///< was wall, is free
constexpr std::uint8_t kUncertainWall = 130;  ///< was wall, is unknown
}  // namespace grey

/** Cells from (x0, y0) up to, without, (x1, y1). */
struct CellBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

/** A map being drawn, box by box, in cells. */
class FloorPlan {
 public:
  /** All unknown. `origin` is the outer corner of cell (0, 0) [m]. */
  FloorPlan(int width, int height, double resolution, Point origin = {});

  /** What of the box lies on the map gets this grey level. */
  void fill(CellBox box, std::uint8_t level);
  /** A closed piece of furniture: its sides are seen, its inside never is. */
  void putFurniture(CellBox box);

  const GreyMap& map() const { return map_; }
  GreyMap take() && { return std::move(map_); }

 private:
  GreyMap map_;
};

}  // namespace roomgraph
