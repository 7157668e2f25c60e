#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/repair/MarkedFile.h"
#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph {

// In:   MarkedFile, and the site that its map and another one belong to
// Out:  CarriedThing of each of its things
// Next: MarkedFile::write, StagedFiles

/** Carries all that a file has marked on the map of run `from` to that of run `to`, see
 *  carryPlaces. */
std::vector<CarriedThing> carryThings(const MarkedFile& file, const SolvedSite& solved,
                                      const RealPoses& real, std::size_t from, std::size_t to,
                                      const ForEach& forEach);

/** The same of places that were carried: `rigid` (new map <- old map) lays those out of which
 *  nothing at all is known. A place that is a thing by itself, as a node of a route, lies in all
 *  things where it was carried: edges end at their nodes, also where a break tears them. */
std::vector<CarriedThing> carriedThings(const MarkedFile& file,
                                        const std::vector<CarriedPlace>& carried,
                                        const Transform2D& rigid);

/** Where a map has a place twice, as beside a break, neighbours may have been carried to one copy
 *  and to the other, and a zone would be torn to shreds. A place of which more than half of its
 *  neighbours (the eight nearest) say that it lies elsewhere, and agree where, follows the nearest
 *  of these; of a thing that lies across a break, each side stays where it is. Returns which ones
 *  have moved. O(n log^2 n) of n places that lie about evenly. */
std::vector<bool> keepShape(const std::vector<Transform2D>& were, std::vector<Transform2D>& poses);

}  // namespace roomgraph
