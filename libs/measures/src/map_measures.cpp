#include "map_measures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fitted_measures.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/breaks/find_pieces.h"
#include "roomgraph/breaks/site_breaks.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/place_runs.h"

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

/** The scans that see what this one sees, but at another time. */
std::vector<std::size_t> othersOf(std::size_t scan, const std::vector<ScanWalls>& scans,
                                  const std::vector<double>& paths) {
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t j = 0; j < scans.size(); ++j) {
    const double far = distance(scans[scan].robot(), scans[j].robot());
    if (far <= fitted::kSameView && std::abs(paths[scan] - paths[j]) >= kWayRound)
      others.push_back({far, j});
  }
  std::sort(others.begin(), others.end());
  if (others.size() > fitted::kMaxVisits) others.resize(fitted::kMaxVisits);
  return mapped(others, [](const auto& other) { return other.second; });
}

/** Squared distance to the nearest wall of a scan, if that is below `best`. */
void searchIn(const ScanWalls& scan, const WallPoint& wall, std::optional<double>& best) {
  for (const WallPoint& other : scan.walls) {
    const Point off = other.place - wall.place;
    if (squaredNorm(off) > WallMap::kReach * WallMap::kReach) continue;
    if (dot(other.normal, wall.normal) < kFacesAlike) continue;
    const double across = dot(off, other.normal);
    const double along = std::max(0.0, std::abs(cross(off, other.normal)) - kSameWall);
    const double far = across * across + along * along;
    if (!best || far < *best) best = far;
  }
}

}  // namespace

MeasuredValue wallDoublingOf(const Run& run) { return overWalls(run.map.wallDoubling, run); }

MeasuredValue wallSharpnessOf(const Run& run) { return overWalls(run.map.wallSharpness, run); }

MeasuredValue brokennessOf(const Site& site, const MapPairs& pairs, const Trust& trust,
                           std::size_t run, std::size_t breaks) {
  if (!site.runs[run]->scans.empty()) return countBreaks(site, pairs, trust, run, breaks);
  const std::vector<Witness> witnesses = witnessesOf(site, pairs, trust, run);
  const auto supports = mapped(witnesses, &Witness::walls);
  return measureOverOthers(supports, [&](std::size_t but) {
    auto value = medianPieces(witnesses, but);
    if (value) --*value;
    return value;
  });
}

MeasuredValue scanDisagreement(const std::vector<ScanWalls>& scans) {
  const std::vector<double> paths = drivenWays(scans);
  std::vector<double> medians;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::vector<std::size_t> others = othersOf(i, scans, paths);
    if (others.empty()) continue;
    std::vector<double> distances;
    double asked = 0;
    for (std::size_t k = 0; k < scans[i].walls.size(); k += 2) {  // half of them will do
      ++asked;
      std::optional<double> best;
      for (const std::size_t j : others) searchIn(scans[j], scans[i].walls[k], best);
      if (best) distances.push_back(std::sqrt(*best));
    }
    if (double(distances.size()) < kFewestThings || double(distances.size()) < kMajority * asked)
      continue;
    medians.push_back(lowerQuantile(std::move(distances), 0.5));
  }
  if (medians.empty()) return {};
  const double count = double(medians.size());
  return {lowerQuantile(std::move(medians), 0.9), count};
}

}  // namespace roomgraph
