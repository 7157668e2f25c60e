#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph::test {

/** Which part of a building a map shows. */
struct Seen {
  double x0 = -1e9, x1 = 1e9;  ///< [m, frame of the building]
};

/** A building about 24 m wide and 16 m deep: a corridor with rooms of uneven widths on both sides,
 *  and doors; sizes by the seed. Cells of 0.05 m. `pose` is map <- building. */
Grid drawnBuilding(std::uint32_t seed, const Transform2D& pose, const Seen& seen = {});

/** A square hall of 12 m with a pillar in its middle: the same after each quarter turn. */
Grid squareHall(const Transform2D& pose);

/** The map with its right half turned by `angle` about the middle, as a jump of the heading does.
 */
Grid bent(const Grid& grid, double angle);

/** The map with the walls within 3 m of a place drawn once more, turned about it, as a run whose
 *  last scans are turned does. */
Grid withTornEnd(const Grid& grid, Point about, double turn);

/** relateRuns, one pair after the other. */
MapPairs related(const std::vector<Run>& runs, const KeptPairs& kept = {});

}  // namespace roomgraph::test
