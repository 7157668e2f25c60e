#include "roomgraph/compare/map_measures.h"

#include <algorithm>
#include <utility>

#include "measure_over_others.h"
#include "roomgraph/compare/rigid_pieces.h"
#include "roomgraph/compare/scan_disagreement.h"
#include "roomgraph/compare/wall_doubling.h"

namespace roomgraph {
namespace {

constexpr double kMinPoints = 300, kMinScans = 10;
constexpr double kMinShare = 0.3;  // of the walls found, for pieces that can be counted

Measure measure(const char* name, const char* unit, const Figure& figure, double minSupport) {
  Measure result;
  result.name = name, result.unit = unit;
  result.value = figure.value, result.support = figure.support;
  result.isMeaningful = figure.value && figure.support >= minSupport;
  return result;
}

/** What one other run says of the pieces of a run; without trust where it says nothing. */
struct Witness {
  double pieces = 0, trust = 0, walls = 0;
};

/** Of the witnesses with trust, leaving one out. */
std::optional<double> weightedMedian(std::vector<Witness> witnesses, std::size_t but) {
  if (but < witnesses.size()) witnesses.erase(witnesses.begin() + std::ptrdiff_t(but));
  double all = 0, below = 0;
  for (const Witness& w : witnesses) all += w.trust;
  std::sort(witnesses.begin(), witnesses.end(),
            [](const Witness& l, const Witness& r) { return l.pieces < r.pieces; });
  for (const Witness& w : witnesses) {
    below += w.trust;
    if (w.trust > 0 && 2 * below >= all) return w.pieces;
  }
  return std::nullopt;
}

/** Of all runs, by their number. */
std::vector<Witness> witnessesOf(const PlacedRuns& site,
                                 const std::vector<std::vector<MapPair>>& pairs, std::size_t run) {
  std::vector<Witness> witnesses(site.runs.size());
  for (std::size_t j = 0; j < site.runs.size(); ++j) {
    if (j == run || site.trust[j] <= 0) continue;
    const FollowedWalls& followed = run < j ? pairs[run][j].aInB : pairs[j][run].bInA;
    if (followed.share < kMinShare) continue;
    witnesses[j].pieces = double(rigidPieces(site.runs[run]->map.patches, followed, {}));
    witnesses[j].trust = site.trust[j];
    for (const FollowedPatch& f : followed.patches) witnesses[j].walls += f.walls;
  }
  return witnesses;
}

}  // namespace

std::vector<Measure> ownMeasuresOf(const PreparedRun& run) {
  const double walls = double(run.map.walls.size());
  return {measure("wall_doubling", "1", {wallDoubling(run.map), walls}, kMinPoints),
          measure("wall_sharpness", "1", {run.map.wallSharpness, walls}, kMinPoints),
          measure("scan_disagreement", "m", scanDisagreement(run.scans, {}), kMinScans)};
}

Measure brokennessOf(const PlacedRuns& site, const std::vector<std::vector<MapPair>>& pairs,
                     std::size_t run, std::size_t breaks) {
  const std::vector<Witness> witnesses = witnessesOf(site, pairs, run);
  Measure result;
  result.name = "brokenness", result.unit = "pieces";
  std::vector<double> supports;
  for (const Witness& witness : witnesses) supports.push_back(witness.walls);
  measureOverOthers(result, supports, kMinPoints, [&](std::size_t but) {
    auto value = weightedMedian(witnesses, but);
    if (value) --*value;
    return value;
  });
  const auto& scans = site.runs[run]->scans;
  if (!result.value || scans.empty()) return result;
  // Scans tell where the run breaks, so that the pieces need not be guessed from its walls.
  const bool hasOthers = bool(result.low);
  result.value = double(breaks), result.support = double(scans.size());
  result.low = result.high = std::nullopt;
  result.isMeaningful = hasOthers && result.support >= kMinScans;
  return result;
}

}  // namespace roomgraph
