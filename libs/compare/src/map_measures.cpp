#include "roomgraph/compare/map_measures.h"

#include <algorithm>
#include <utility>

#include "roomgraph/compare/rigid_pieces.h"
#include "roomgraph/compare/scan_disagreement.h"
#include "roomgraph/compare/wall_doubling.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMinRuns = 3;
constexpr double kMinPoints = 300, kMinScans = 10;
constexpr double kMinShare = 0.3;  // of the walls found, for pieces that can be counted

Measure measure(const char* name, const char* unit, const Figure& figure, double minSupport) {
  Measure result;
  result.name = name, result.unit = unit;
  result.value = figure.value, result.support = figure.support;
  result.isMeaningful = figure.value && figure.support >= minSupport;
  return result;
}

/** What one other run says of the pieces of a run. */
struct Witness {
  double pieces = 0, trust = 0, walls = 0;
};

std::optional<double> weightedMedian(std::vector<Witness> witnesses, std::size_t but) {
  double all = 0, below = 0;
  if (but < witnesses.size()) witnesses.erase(witnesses.begin() + std::ptrdiff_t(but));
  for (const Witness& w : witnesses) all += w.trust;
  std::sort(witnesses.begin(), witnesses.end(),
            [](const Witness& l, const Witness& r) { return l.pieces < r.pieces; });
  for (const Witness& w : witnesses) {
    below += w.trust;
    if (2 * below >= all) return w.pieces;
  }
  return std::nullopt;
}

std::vector<Witness> witnessesOf(const PlacedRuns& site,
                                 const std::vector<std::vector<MapPair>>& pairs, std::size_t run) {
  std::vector<Witness> witnesses;
  for (std::size_t j = 0; j < site.runs.size(); ++j) {
    if (j == run || site.trust[j] <= 0) continue;
    const FollowedWalls& followed = run < j ? pairs[run][j].aInB : pairs[j][run].bInA;
    if (followed.share < kMinShare) continue;
    Witness witness;
    witness.pieces = double(rigidPieces(site.runs[run]->map.patches, followed, {}));
    witness.trust = site.trust[j];
    for (const FollowedPatch& f : followed.patches) witness.walls += f.walls;
    witnesses.push_back(witness);
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
  if (witnesses.empty()) return result;
  const bool isEnough = witnesses.size() + 1 >= kMinRuns;
  if (!site.runs[run]->scans.empty()) {
    result.value = double(breaks), result.support = double(site.runs[run]->scans.size());
    result.isMeaningful = isEnough && result.support >= kMinScans;
    return result;
  }
  for (const Witness& witness : witnesses) result.support += witness.walls;
  result.value = *weightedMedian(witnesses, witnesses.size()) - 1;
  result.isMeaningful = isEnough && result.support >= kMinPoints;
  for (std::size_t j = 0; witnesses.size() > 1 && j < witnesses.size(); ++j) {
    const double value = *weightedMedian(witnesses, j) - 1;
    result.low = std::min(result.low.value_or(value), value);
    result.high = std::max(result.high.value_or(value), value);
  }
  return result;
}

}  // namespace roomgraph
