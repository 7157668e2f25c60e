#pragma once
#include <optional>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/PlacedRuns.h"
#include "roomgraph/relate/relate_runs.h"
#include "roomgraph/relate/site_poses.h"

namespace roomgraph {

/** A set of runs that lie in one frame. */
struct Site {
  std::vector<std::size_t> runs;   ///< ascending
  std::vector<Transform2D> poses;  ///< site <- run
};

/** The runs of the site and their poses, see compareRuns. */
Site siteOf(const std::vector<PreparedRun>& runs, const Pairs& pairs,
            const std::vector<MapPair>& related, const SitePosesOptions& options,
            std::optional<std::size_t> reference);

/** The runs of the site; trust is left open. */
PlacedRuns placed(const std::vector<PreparedRun>& runs, const Site& site, const ForEach& forEach);

/** What is known of all pairs of a site, [i][j] with i < j. Pairs that have not found each other,
 * or lie otherwise than in the site, are followed from the poses in the site, if they fit there. */
std::vector<std::vector<MapPair>> pairsIn(const PlacedRuns& site, const Site& members,
                                          std::size_t runs, const std::vector<MapPair>& related,
                                          const ForEach& forEach);

/** What of these is known of run `of` in another run. */
const FollowedWalls& followedIn(const std::vector<std::vector<MapPair>>& pairs, std::size_t of,
                                std::size_t in);

/** The bends of these. The better map of two follows the worse one over a part of it only: so the
 *  larger bend of both ways counts. */
std::vector<std::vector<PairBend>> bendsOf(const std::vector<std::vector<MapPair>>& pairs);

}  // namespace roomgraph
