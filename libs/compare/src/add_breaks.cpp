#include "add_breaks.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

constexpr std::size_t kWitnesses = 3;  // runs in which the scans of another are tracked
constexpr double kMinShare = 0.3;      // of a run's walls that a witness must have

/** The runs that tell best where `run` breaks: those that are trusted most. */
std::vector<std::size_t> witnessesOf(std::size_t run, const PlacedRuns& site,
                                     const std::vector<std::vector<MapPair>>& pairs) {
  std::vector<std::size_t> others;
  for (std::size_t j = 0; j < site.runs.size(); ++j)
    if (j != run && followedIn(pairs, run, j).share >= kMinShare) others.push_back(j);
  std::stable_sort(others.begin(), others.end(),
                   [&](std::size_t l, std::size_t r) { return site.trust[l] > site.trust[r]; });
  if (others.size() > kWitnesses) others.resize(kWitnesses);
  // One map alone cannot tell its own breaks from those of a better one.
  if (others.size() == 1 && site.trust[others[0]] < site.trust[run]) return {};
  return others;
}

/** Trust is steep: its root lets two good maps outvote a better one. */
std::vector<double> votesOf(const std::vector<std::size_t>& others, const PlacedRuns& site) {
  std::vector<double> votes;
  for (const std::size_t j : others) votes.push_back(std::sqrt(site.trust[j]));
  return votes;
}

/** Of a run with scans: where their poses jump. */
void addJumps(std::vector<MapBreak>& breaks, const PlacedRuns& site, std::size_t run,
              const std::vector<std::size_t>& others,
              const std::vector<std::vector<MapPair>>& pairs, const CompareRunsOptions& options) {
  const std::vector<ScanWalls>& scans = site.runs[run]->scans;
  std::vector<ScanTrack> tracks;
  for (const std::size_t j : others)
    tracks.push_back(trackScans(scans, site.runs[run]->map.patches, followedIn(pairs, run, j),
                                site.runs[j]->map, options.trackScans));
  for (const ScanBreak& found :
       findBreaks(scans, tracks, votesOf(others, site), options.findBreaks)) {
    const std::size_t track = found.seenIn.front();
    const Transform2D inOther = tracks[track][found.scan].value_or(Transform2D{});
    breaks.push_back({site.runs[run]->name,
                      site.poses[others[track]](inOther(scans[found.scan].at)), found.rotation,
                      found.shift});
  }
}

/** Of a run without scans: whether it lies in the others as two rigid pieces. */
void addSeam(std::vector<MapBreak>& breaks, const PlacedRuns& site, std::size_t run,
             const std::vector<std::size_t>& others, const std::vector<std::vector<MapPair>>& pairs,
             const CompareRunsOptions& options) {
  std::vector<double> xs, ys, rotations, shifts;
  double weight = 0, all = 0;
  const std::vector<double> votes = votesOf(others, site);
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::size_t j = others[k];
    all += votes[k];
    const auto found =
        findPieces(site.runs[run]->map, followedIn(pairs, run, j), options.findPieces);
    if (!found) continue;
    weight += votes[k];
    const Point place = site.poses[j](found->pose(found->place));
    xs.push_back(place.x), ys.push_back(place.y);
    rotations.push_back(found->rotation), shifts.push_back(found->shift);
  }
  if (2 * weight <= all || xs.empty()) return;
  breaks.push_back(
      {site.runs[run]->name, {median(xs), median(ys)}, median(rotations), median(shifts)});
}

}  // namespace

void addBreaks(Comparison& result, const PlacedRuns& site,
               const std::vector<std::vector<MapPair>>& pairs, const CompareRunsOptions& options) {
  std::vector<std::vector<MapBreak>> breaks(site.runs.size());
  options.forEach(site.runs.size(), [&](std::size_t i) {
    const std::vector<std::size_t> others = witnessesOf(i, site, pairs);
    if (site.runs[i]->scans.empty())
      addSeam(breaks[i], site, i, others, pairs, options);
    else
      addJumps(breaks[i], site, i, others, pairs, options);
  });
  for (const std::vector<MapBreak>& ofRun : breaks)
    result.breaks.insert(result.breaks.end(), ofRun.begin(), ofRun.end());
}

}  // namespace roomgraph
