#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/breaks/find_breaks.h"
#include "roomgraph/breaks/find_pieces.h"
#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, how each two of them lie in each other, their consensus, whom to trust
// Out:  MapBreak
// Next: measureSite, summarize

/** Share of a run's walls that another run must have, to tell where it breaks. */
constexpr double kWitnessShare = 0.3;

struct SiteBreaksOptions {
  FindBreaksOptions findBreaks;
  FindPiecesOptions findPieces;
  double sameTurn = 0.1;   ///< of one break of a run without scans, in two maps [rad]
  double samePlace = 1.5;  ///< the same, of its shift [m]
  double minVotes = 0.6;   ///< share that must tell of it
  double minKnown = 0.5;   ///< share of each piece that a map must have, to deny the break
};

/** The breaks of each run of the site, along it. Of a run with scans: where the consensus has
 *  torn it from one scan to the next. Of one without: where it has the same two pieces in
 *  most of the maps that are trusted most and know both, by their votes.
 *  O(runs * (scans + patches^2)). */
std::vector<std::vector<MapBreak>> siteBreaks(const Site& site, const MapPairs& pairs,
                                              const Consensus& consensus, const Trust& trust,
                                              const SiteBreaksOptions& options,
                                              const ForEach& forEach);

}  // namespace roomgraph
