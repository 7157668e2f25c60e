#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/breaks/ScanBreak.h"
#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, how each two of them lie in each other, their consensus, whom to trust
// Out:  MapBreak
// Next: measureSite, summarize

/** Share of a run's walls that another run must have, to tell where it breaks. */
constexpr double kWitnessShare = 0.3;

/** The breaks of each run of the site, along it. Of a run with scans: where the consensus has
 *  torn it from one scan to the next. Of one without: where it has the same two pieces in
 *  most of the maps that are trusted most and know both, by their votes.
 *  O(runs * (scans + patches^2)). */
std::vector<std::vector<MapBreak>> siteBreaks(const Site& site, const MapPairs& pairs,
                                              const Consensus& consensus, const Trust& trust,
                                              const FindBreaksOptions& options,
                                              const ForEach& forEach);

/** Where the poses of a run's scans jump from one scan to the next, while they are steady before
 *  and after; and, however unsteady they are, where they turn or shift by so much in a few scans
 *  that no noise does it, and stay so. A drift is no break. By scan. None within two scans of
 *  either end. Cost: O(scans * window). */
std::vector<ScanBreak> findBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                  const FindBreaksOptions& options);

/** Where a run tore that the consensus has torn before the scan `found`. Of scans that no other run
 *  has seen (`isSeen`, by scan) the consensus cannot tell on which side of the break they lie. So
 *  of all places among them that is taken where a scan has least of the walls of the one before, by
 *  the run's own poses; `found` where that is not plain. At most five scans away. O(walls^2). */
std::size_t placeBreak(const std::vector<ScanWalls>& scans, const std::vector<bool>& isSeen,
                       std::size_t found);

}  // namespace roomgraph
