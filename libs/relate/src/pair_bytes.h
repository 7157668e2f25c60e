#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {

// Ours
// In:   MapPair
// Out:  its bytes, to be kept from call to call
// Next: relateRuns

/** What a map is to the comparison, as 64 hex digits: all that relating it to others depends on, so
 *  two files with the same walls, states and frame have the same, if both have scans or neither.
 *  O(cells). */
std::string fingerprint(const WallMap& map);

/** All of the pair, exactly, behind a checksum; for machines of one byte order. */
std::string pairBytes(const MapPair& pair);

/** The pair of pairBytes, of the maps a and b. Nothing for bytes that are damaged, of another
 *  kind or of other maps, whatever their checksum says. */
std::optional<MapPair> pairOfBytes(std::string_view bytes, const WallMap& a, const WallMap& b);

}  // namespace roomgraph
