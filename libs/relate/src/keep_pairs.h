#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgraph/align/FullMaps.h"
#include "roomgraph/relate/KeptPairs.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {

// In:   a function that relates two runs
// Out:  the same, which remembers
// Next: relateRuns

/** Two runs, and one that both have been related to: itself one of both for a pair that is searched
 *  for. */
struct PairOver {
  std::size_t hub = 0, a = 0, b = 0;
};

/** Relates the maps of two runs, both of which are completed in the second argument. */
using RelatePair = std::function<MapPair(const PairOver&, FullMaps&)>;

/** The same function, but what it gave for the same maps before is read from where it is kept, and
 *  what is new is written there; `relate` itself where nothing is kept. `how`: what else the answer
 *  hangs on. The names under which pairs are kept stand for the maps, the version of the program
 *  and the sources that relate maps, so that an answer of other ones is never taken. */
RelatePair keepPairs(RelatePair relate, const std::vector<Run>& runs, const std::string& how,
                     const KeptPairs& kept);

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
