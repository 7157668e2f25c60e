#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/align/SparseCells.h"
#include "roomgraph/align/WallPatches.h"
#include "roomgraph/align/WallPoint.h"
#include "roomgraph/geometry/Point.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** The cells at the edges of what is drawn as occupied, on the map's own cells, however small: two
 *  drives never share them, edits of one picture do. */
struct DrawnEdges {
  GridFrame frame;           ///< around them, on the cells of the map as it was read
  std::vector<bool> isEdge;  ///< row-major
};

/** What the alignment needs to know of a map; made once, then used for all pairs. */
struct WallMap {
  static constexpr double kReach = 1;  ///< walls farther away are not in `nearest` [m]

  std::vector<WallPoint> walls;  ///< about one per cell of `frame` and direction, by row
  GridFrame frame;               ///< around all that is known, with a margin
  std::vector<State> states;     ///< row-major, as in Grid
  /** How far each cell is from the nearest that is not free [m]; 0 where it is not free itself. */
  SparseCells<float> depths;
  /** For each octant and cell the wall point that is nearest among those whose normal is within 45
   *  degrees of that octant; kNoIndex where none is in reach. */
  std::array<SparseCells<std::uint32_t>, kOctants> nearest;
  std::vector<std::uint32_t> freeCells;  ///< evenly spread over the free space: indices of `states`
  double freeArea = 0;                   ///< [m2]
  std::vector<double> turns;  ///< how much wall faces which way, over equal steps of the circle
  WallPatches patches;        ///< of `walls`
  DrawnEdges edges;
  std::optional<double> direction;      ///< of most `walls`, up to quarter turns [rad]
  std::optional<double> axisDeviation;  ///< of `walls`: how far they are from right angles [rad]
  std::optional<double> wallSharpness;  ///< of the map as it was drawn, see there
  std::optional<double> wallDoubling;   ///< of `walls`: the share of them that are there twice
  bool hasScans = false;  ///< its run has scans, so that a piece that only looks alike shows later

  [[nodiscard]] Point middle() const {  ///< of `frame` [m]
    return frame.origin + 0.5 * frame.resolution * Point{double(frame.width), double(frame.height)};
  }
  [[nodiscard]] Point placeOf(std::size_t cell) const {  ///< the centre of a cell of `frame` [m]
    const std::size_t width = std::size_t(frame.width);
    return frame.center({int(cell % width), int(cell / width)});
  }
  /** Without `nearest` and `depths`: no walls can be looked up in it. */
  [[nodiscard]] bool isBare() const { return nearest.front().size() != states.size(); }
  [[nodiscard]] double wallSpacing() const {
    return frame.resolution;
  }  ///< of `walls` along a wall [m]
};

}  // namespace roomgraph
