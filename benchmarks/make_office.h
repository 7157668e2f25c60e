#pragma once
#include <cstdint>

#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

struct MakeOfficeOptions {
  int width = 1000, height = 1000;  ///< of the map [cells of 0.05 m], at least 400 each
  std::uint32_t seed = 1;
  bool isPlain = false;  ///< neither furniture nor noise at the walls
};

/** An artificial office that fills the map but for 1 m at its border: a lattice of corridors, 2 m
 *  wide, with rooms on both sides, doors, some furniture, some rooms that nobody entered, and
 *  ragged walls; unknown outside. The same options give the same bytes on every machine. Needs no
 *  memory besides the map. O(cells). Throws UsageError where the map is too small. */
GreyMap makeOffice(const MakeOfficeOptions& options);

}  // namespace roomgraph
