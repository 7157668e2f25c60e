#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/breaks/find_breaks.h"
#include "roomgraph/breaks/find_pieces.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, how each pair of them lies in each other, and whom to trust
// Out:  MapBreak
// Next: measureSite, summarize

/** Share of a run's walls that another run must have, to tell where it breaks. */
constexpr double kWitnessShare = 0.3;

struct SiteBreaksOptions {
  TrackScansOptions trackScans;
  FindBreaksOptions findBreaks;
  FindPiecesOptions findPieces;
};

/** The breaks of each run of the site, along it. They are looked for in the maps of the runs that
 *  are trusted most: where the scans of a run jump, or whether a run without scans has two rigid
 *  pieces. More than half of these maps must show a break. O(runs * scans * walls). */
std::vector<std::vector<MapBreak>> siteBreaks(const Site& site, const MapPairs& pairs,
                                              const Trust& trust, const SiteBreaksOptions& options,
                                              const ForEach& forEach);

}  // namespace roomgraph
