#include "map_measures.h"

#include <utility>

#include "measure_over_others.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/breaks/rigid_pieces.h"
#include "roomgraph/breaks/site_breaks.h"
#include "roomgraph/relate/place_runs.h"
#include "scan_disagreement.h"

namespace roomgraph {
namespace {

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
    witnesses[j].pieces = double(rigidPieces(site.runs[run]->map.patches, followed).size());
    witnesses[j].trust = trust[j];
    for (const FollowedPatch& f : followed.patches) witnesses[j].walls += f.walls;
  }
  return witnesses;
}

/** Scans tell where a run breaks, so that its pieces need not be guessed from its walls. */
MeasuredValue countBreaks(const Site& site, const MapPairs& pairs, const Trust& trust,
                          std::size_t run, std::size_t breaks) {
  std::size_t others = 0;
  for (std::size_t j = 0; j < site.runs.size(); ++j) others += canTell(pairs, trust, run, j);
  if (others == 0) return {};
  const double scans = double(site.runs[run]->scans.size());
  return {double(breaks), scans, {}, {}, others >= kFewestOthers, kFewestWalls / kFewestThings};
}

MeasuredValue overWalls(std::optional<double> value, const Run& run) {
  return {value, double(run.map.walls.size())};
}

}  // namespace

MeasuredValue wallDoublingOf(const Run& run) { return overWalls(run.map.wallDoubling, run); }

MeasuredValue wallSharpnessOf(const Run& run) { return overWalls(run.map.wallSharpness, run); }

MeasuredValue scanDisagreementOf(const Run& run) {
  const Figure scans = scanDisagreement(run.scans);
  return {scans.value, scans.support};
}

MeasuredValue brokennessOf(const Site& site, const MapPairs& pairs, const Trust& trust,
                           std::size_t run, std::size_t breaks) {
  if (!site.runs[run]->scans.empty()) return countBreaks(site, pairs, trust, run, breaks);
  const std::vector<Witness> witnesses = witnessesOf(site, pairs, trust, run);
  std::vector<double> supports;
  for (const Witness& witness : witnesses) supports.push_back(witness.walls);
  return measureOverOthers(supports, [&](std::size_t but) {
    auto value = medianPieces(witnesses, but);
    if (value) --*value;
    return value;
  });
}

}  // namespace roomgraph
