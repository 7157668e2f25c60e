#pragma once
#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/align_maps.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// In:   two WallMap
// Out:  MapPair: all that is to be known of two maps, beside the others
// Next: compareRuns

/** How two maps lie in each other, as a whole and place by place. */
struct MapPair {
  Alignment alignment;        ///< of b in a
  FollowedWalls bInA, aInB;   ///< nothing where they are not of the same site
  bool areIdentical = false;  ///< cell by cell
  bool areEdits = false;      ///< of one picture, or identical: see areEdits
  bool areStoreys = false;    ///< of one building, see areStoreys: then not of the same site
};

/** Aligns two maps, and follows the walls of each in the other. Swapping them swaps the answers.
 *  Maps that are said to show one site do so by takeLikeliest.
 *  O(alignMaps + followWalls). */
MapPair relateMaps(const WallMap& a, const WallMap& b, bool areOneSite = false);

/** Takes two maps for those of one site, as somebody says that they are though they hardly show it,
 *  unless another pose is about as likely. The confidence is then that beside the runner-up, and
 *  siteConfidence stays as it is. */
void takeLikeliest(Alignment& alignment);

/** What relateMaps gives where the pose of both in a third map, the hub, is known already, so that
 *  no search is needed: their poses follow from what was found of the two, as a whole and piece by
 *  piece, and of one that is not sure, as in a symmetric building, from its other answers, too.
 *  Where the third map is not of the same site, or sure poses do not agree, it is relateMaps after
 *  all. */
MapPair relateMapsOver(const MapPair& hubAndA, const MapPair& hubAndB, const WallMap& a,
                       const WallMap& b);

/** The same for two maps whose frames are said to be the same: their pose is nothing, and sure.
 *  Maps that contradict each other there are not of the same site. */
MapPair relateAlignedMaps(const WallMap& a, const WallMap& b);

/** That of maps which are known to lie in each other at the first of `poses`, and in part at the
 *  others (a <- b). O(verifyAlignment). */
Alignment alignmentAt(const WallMap& a, const WallMap& b, std::vector<Transform2D> poses);

/** The same pair with b named first. */
MapPair swapped(MapPair pair);

/** Follows the walls of each in the other again, from the first of `poses` (a <- b) on. */
void follow(MapPair& pair, const WallMap& a, const WallMap& b,
            const std::vector<Transform2D>& poses);

/** Whether two maps agree in their outer walls and not in their inner ones: they surely lie in each
 *  other, and hardly bend, and yet of the straight walls of either map many stand where the other
 *  has seen free space. Furniture is seldom straight; walls that were built or torn down are there
 *  in one map only; and maps that bend or break are not asked. O(walls). */
bool areStoreys(const MapPair& pair, const WallMap& a, const WallMap& b);

/** The mirror image of a map: what a scanner that was mounted upside down draws. Its x axis points
 *  the other way. Complete, if the map is. O(cells + walls * walls within 4 m). */
WallMap mirrored(const WallMap& map);

}  // namespace roomgraph
