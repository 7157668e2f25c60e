#pragma once
#include <vector>

#include "fit_shape.h"

namespace roomgraph {

// In:   the rooms of a site, and the areas of one run
// Out:  AreaMatch for each room
// Next: siteRooms, nameRooms

/** The rooms of a site, and which are open to which. */
struct RoomSet {
  std::vector<SiteShape> shapes;
  std::vector<std::vector<std::size_t>> neighbours;  ///< of each room, ascending
};

/** What one room is in a run. */
struct AreaMatch {
  std::vector<std::size_t> areas;  ///< of the run; the one that fits best first; empty for none
  RoomMove move;                   ///< of the room in this run; of a room that is not matched, that
                                   ///< of the nearest one that is
  double overlap = 0;              ///< intersection over union with the first area
  bool isMerged = false;           ///< the area holds another room, too
  double known = 0;                ///< share of the room that the run has looked at
  double free = 0;                 ///< share of the room that it has looked at, and is no wall

  bool isMatched() const { return !areas.empty(); }
};

/** What each room may be in a run, if it lies about in its place; made once, then used again. */
using RoomFits = std::vector<std::map<std::size_t, ShapeFit>>;

/** The least overlap of a room and its area, unless its doors tell it. */
constexpr double kMinOverlap = 0.35;

/** The fits of the rooms that `fits` has none of yet are added to it. */
void addFits(const std::vector<SiteShape>& rooms, const GridFrame& frame, const RunAreas& run,
             RoomFits& fits);

/** Matches rooms and areas one to one: greedily by overlap after a small move of the room, then
 *  again with what the neighbours say. A room is also looked for where its neighbours have moved
 *  to, so that what lies behind a bend is found. Then areas without a room that lie in one are its
 *  pieces, and rooms without an area that lie in one are merged into it. `fits` of all rooms. Ties
 *  by room, then area.
 *  O(rounds * rooms * samples). */
std::vector<AreaMatch> matchAreas(const RoomSet& rooms, const RoomFits& fits,
                                  const GridFrame& frame, const RunAreas& run);

}  // namespace roomgraph
