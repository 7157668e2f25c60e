#pragma once
#include <map>
#include <vector>

#include "SiteAreas.h"

namespace roomgraph {

// In:   a room, and the areas of a run
// Out:  ShapeFit for each area that may be the room
// Next: matchAreas, consensusRooms

/** How a room lies in a run, against where it lies in the site: turned about its middle, then
 *  shifted. The default: in its place. */
struct RoomMove {
  Point shift;      ///< [m]
  double turn = 0;  ///< [rad]

  /** run's drawing <- site, both in the site's frame; `middle` of the room. */
  Transform2D about(Point middle) const { return carrying(middle, middle + shift, turn); }
};

/** The move of a room about `middle` that is a part of `whole`. */
inline RoomMove moveOf(const Transform2D& whole, Point middle) {
  return {whole(middle) - middle, whole.phi};
}

/** What a run has where a room is laid. */
struct Footprint {
  double samples = 0;                ///< of the room
  double known = 0;                  ///< of those, what the run has looked at
  double free = 0;                   ///< of those, what is no wall there
  std::map<std::size_t, double> in;  ///< of those, how many lie in each area
};

/** Room to count labels in, for many footprints; all 0 between them. */
struct LabelCounts {
  std::vector<std::uint32_t> counts;  ///< by label
  std::vector<std::uint16_t> met;     ///< labels whose count is not 0
};

Footprint footprint(const SiteShape& room, const RoomMove& move, const GridFrame& frame,
                    const RunAreas& run, LabelCounts& buffer);

struct ShapeFit {
  RoomMove move;
  double overlap = 0;  ///< intersection over union; what the run has not looked at is left out
};

/** How a room is looked for round a start. */
struct ShapeSearch {
  double reach = 0;       ///< how far [m]
  double good = 0;        ///< an overlap at a start from which on it is not looked for
  bool isRefined = true;  ///< by small steps at last
};

constexpr ShapeSearch kWideSearch{1.5, 0.8, true};
constexpr ShapeSearch kNearSearch{0.5, 0.8, true};
constexpr ShapeSearch kRoughSearch{1.5, 0.7, false};

/** For each area the move of the room that makes both overlap most: at each of `starts`, then on a
 *  raster round them, then, for the three best, by steps down to 0.05 m and 0.5 degrees. A smaller
 *  move is preferred to a slightly better overlap (0.03 per metre from the start). None where the
 *  run has not looked at half of the room. Deterministic. O(starts * samples). */
std::map<std::size_t, ShapeFit> fitShape(const SiteShape& room, const GridFrame& frame,
                                         const RunAreas& run, const std::vector<RoomMove>& starts,
                                         const ShapeSearch& how = kWideSearch);

}  // namespace roomgraph
