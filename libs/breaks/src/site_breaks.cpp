#include "roomgraph/breaks/site_breaks.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

constexpr std::size_t kWitnesses = 3;  // runs in which the scans of another are tracked

/** Looks for the breaks of one run. */
class BreakSearch {
 public:
  BreakSearch(const Site& site, const MapPairs& pairs, const Trust& trust,
              const SiteBreaksOptions& options, std::size_t run)
      : site_(site), pairs_(pairs), options_(options), run_(run) {
    witnesses_ = witnesses(trust);
    // Trust is steep: its root lets two good maps outvote a better one.
    for (const std::size_t j : witnesses_) votes_.push_back(std::sqrt(trust[j]));
  }

  std::vector<MapBreak> breaks() const {
    return site_.runs[run_]->scans.empty() ? seam() : jumps();
  }

 private:
  /** The runs that tell best where this one breaks: those that are trusted most. */
  std::vector<std::size_t> witnesses(const Trust& trust) const {
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < site_.runs.size(); ++j)
      if (j != run_ && followedIn(pairs_, run_, j).share >= kWitnessShare) others.push_back(j);
    std::stable_sort(others.begin(), others.end(),
                     [&](std::size_t l, std::size_t r) { return trust[l] > trust[r]; });
    if (others.size() > kWitnesses) others.resize(kWitnesses);
    // One map alone cannot tell its own breaks from those of a better one.
    if (others.size() == 1 && trust[others[0]] < trust[run_]) return {};
    return others;
  }

  /** Of a run with scans: where their poses jump. */
  std::vector<MapBreak> jumps() const {
    const std::vector<ScanWalls>& scans = site_.runs[run_]->scans;
    std::vector<ScanTrack> tracks;
    for (const std::size_t j : witnesses_)
      tracks.push_back(trackScans(scans, site_.runs[run_]->map.patches, followedIn(pairs_, run_, j),
                                  site_.runs[j]->map, options_.trackScans));
    std::vector<MapBreak> breaks;
    for (const ScanBreak& found : findBreaks(scans, tracks, votes_, options_.findBreaks)) {
      const std::size_t track = found.seenIn.front();
      const Transform2D inOther = tracks[track][found.scan].value_or(Transform2D{});
      breaks.push_back({site_.runs[run_]->name,
                        site_.poses[witnesses_[track]](inOther(scans[found.scan].at)),
                        found.rotation, found.shift});
    }
    return breaks;
  }

  /** Of a run without scans: whether it lies in the others as two rigid pieces. */
  std::vector<MapBreak> seam() const {
    std::vector<double> xs, ys, rotations, shifts;
    double weight = 0, all = 0;
    for (std::size_t k = 0; k < witnesses_.size(); ++k) {
      const std::size_t j = witnesses_[k];
      all += votes_[k];
      const auto found =
          findPieces(site_.runs[run_]->map, followedIn(pairs_, run_, j), options_.findPieces);
      if (!found) continue;
      weight += votes_[k];
      const Point place = site_.poses[j](found->pose(found->place));
      xs.push_back(place.x), ys.push_back(place.y);
      rotations.push_back(found->rotation), shifts.push_back(found->shift);
    }
    if (2 * weight <= all || xs.empty()) return {};
    return {{site_.runs[run_]->name, {median(xs), median(ys)}, median(rotations), median(shifts)}};
  }

  const Site& site_;
  const MapPairs& pairs_;
  const SiteBreaksOptions& options_;
  std::size_t run_;
  std::vector<std::size_t> witnesses_;
  std::vector<double> votes_;  // of each witness
};

}  // namespace

std::vector<std::vector<MapBreak>> siteBreaks(const Site& site, const MapPairs& pairs,
                                              const Trust& trust, const SiteBreaksOptions& options,
                                              const ForEach& forEach) {
  std::vector<std::vector<MapBreak>> breaks(site.runs.size());
  forEach(breaks.size(),
          [&](std::size_t i) { breaks[i] = BreakSearch(site, pairs, trust, options, i).breaks(); });
  return breaks;
}

}  // namespace roomgraph
