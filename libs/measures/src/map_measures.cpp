#include "map_measures.h"

#include <utility>

#include "measure_over_others.h"
#include "roomgraph/align/wall_doubling.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/breaks/rigid_pieces.h"
#include "roomgraph/breaks/site_breaks.h"
#include "roomgraph/relate/place_runs.h"
#include "scan_disagreement.h"

namespace roomgraph {
namespace {

constexpr double kMinScans = 10;  // that tell where a run breaks

/** What one other run says of the pieces of a run; without trust where it says nothing. */
struct Witness {
  double pieces = 0, trust = 0, walls = 0;
};

/** Of all witnesses but one. */
std::optional<double> medianPieces(const std::vector<Witness>& witnesses, std::size_t but) {
  std::vector<WeightedValue> pieces;
  for (std::size_t j = 0; j < witnesses.size(); ++j)
    if (j != but) pieces.push_back({witnesses[j].pieces, witnesses[j].trust});
  return lowerWeightedMedian(std::move(pieces));
}

/** Whether run `in` has enough of the walls of `run` to tell of its pieces. */
bool canTell(const MapPairs& pairs, const Trust& trust, std::size_t run, std::size_t in) {
  return in != run && trust[in] > 0 && followedIn(pairs, run, in).share >= kWitnessShare;
}

/** Of all runs, by their number. */
std::vector<Witness> witnessesOf(const Site& site, const MapPairs& pairs, const Trust& trust,
                                 std::size_t run) {
  std::vector<Witness> witnesses(site.runs.size());
  for (std::size_t j = 0; j < site.runs.size(); ++j) {
    if (!canTell(pairs, trust, run, j)) continue;
    const FollowedWalls& followed = followedIn(pairs, run, j);
    witnesses[j].pieces = double(rigidPieces(site.runs[run]->map.patches, followed, {}));
    witnesses[j].trust = trust[j];
    for (const FollowedPatch& f : followed.patches) witnesses[j].walls += f.walls;
  }
  return witnesses;
}

/** Scans tell where a run breaks, so that its pieces need not be guessed from its walls. */
void countBreaks(Measure& measure, const Site& site, const MapPairs& pairs, const Trust& trust,
                 std::size_t run, std::size_t breaks) {
  std::size_t others = 0;
  for (std::size_t j = 0; j < site.runs.size(); ++j) others += canTell(pairs, trust, run, j);
  if (others == 0) return;
  measure.value = double(breaks), measure.support = double(site.runs[run]->scans.size());
  measure.isMeaningful = others >= 2 && measure.support >= kMinScans;
}

}  // namespace

std::vector<Measure> ownMeasuresOf(const Run& run) {
  const double walls = double(run.map.walls.size());
  const Figure scans = scanDisagreement(run.scans, {});
  return {measureNamed("wall_doubling", wallDoubling(run.map), walls),
          measureNamed("wall_sharpness", run.map.wallSharpness, walls),
          measureNamed("scan_disagreement", scans.value, scans.support)};
}

Measure brokennessOf(const Site& site, const MapPairs& pairs, const Trust& trust, std::size_t run,
                     std::size_t breaks) {
  Measure result = measureNamed("brokenness");
  if (!site.runs[run]->scans.empty()) {
    countBreaks(result, site, pairs, trust, run, breaks);
    return result;
  }
  const std::vector<Witness> witnesses = witnessesOf(site, pairs, trust, run);
  std::vector<double> supports;
  for (const Witness& witness : witnesses) supports.push_back(witness.walls);
  measureOverOthers(result, supports, [&](std::size_t but) {
    auto value = medianPieces(witnesses, but);
    if (value) --*value;
    return value;
  });
  return result;
}

}  // namespace roomgraph
