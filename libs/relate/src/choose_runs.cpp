#include "choose_runs.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "fitted_relate.h"
#include "roomgraph/align/shared_edges.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/shared_drives.h"

namespace roomgraph {
namespace {

std::int64_t squareAt(double metres) {
  constexpr double most = 1 << 30;  // so that both coordinates fit into one number
  return std::int64_t(std::floor(std::clamp(metres, -most, most)));
}

/** How many of some runs have seen a square. */
using SeenCounts = std::unordered_map<std::int64_t, std::size_t>;

class Choosing {
 public:
  Choosing(const std::vector<const Run*>& runs, const std::vector<SeenPlaces>& seen)
      : runs_(runs), seen_(seen), isChosen_(runs.size()) {
    SeenCounts all;
    for (const SeenPlaces& places : seen)
      for (const std::int64_t place : places) ++all[place];
    for (const auto& [place, count] : all)
      if (count >= kFewestOthers) worth_.insert(place);
  }

  std::vector<std::size_t> chosen(std::size_t count, std::size_t fixed) {
    for (std::size_t i = 0; i < std::min(fixed, runs_.size()); ++i) choose(i);
    chooseInOrder(count * 2 / 3, Drives::distinct);
    while (chosen_.size() < 2 * count) {
      const std::size_t next = addingMost();
      if (next == runs_.size() || double(addedBy(next)) < fitted::kMuch * double(worth_.size()))
        break;
      choose(next);
    }
    chooseInOrder(count, Drives::distinct);
    chooseInOrder(count, Drives::any);
    return chosen_;
  }

 private:
  enum class Drives { distinct, any };

  void chooseInOrder(std::size_t count, Drives drives) {
    for (std::size_t i = 0; i < runs_.size() && chosen_.size() < count; ++i)
      if (isCandidate(i) && (drives == Drives::any || !isOfChosenDrive(i))) choose(i);
  }

  void choose(std::size_t run) {
    if (isChosen_[run]) return;
    isChosen_[run] = true;
    chosen_.push_back(run);
    for (const std::int64_t place : seen_[run]) ++counts_[place];
    for (const ScanWalls& scan : runs_[run]->scans) scans_.insert(scan.scanId);
  }

  bool isCandidate(std::size_t run) const {
    if (isChosen_[run]) return false;
    for (std::size_t j = 0; j < runs_.size(); ++j) {
      const bool isBetter = isChosen_[j] || (runs_[run]->scans.empty() && !runs_[j]->scans.empty());
      if (isBetter && areIdentical(runs_[run]->map, runs_[j]->map)) return false;
    }
    return true;
  }

  bool isOfChosenDrive(std::size_t run) const {
    const std::vector<ScanWalls>& scans = runs_[run]->scans;
    const auto same =
        countIf(scans, [&](const ScanWalls& scan) { return scans_.count(scan.scanId) > 0; });
    return sharesDrive(std::size_t(same), scans.size());
  }

  std::size_t addedBy(std::size_t run) const {
    const SeenPlaces& places = seen_[run];
    return countIf(places, [&](std::int64_t place) {
      const auto count = counts_.find(place);
      return worth_.count(place) > 0 && (count == counts_.end() || count->second < kFewestOthers);
    });
  }

  /** The run that adds most, of equal ones the first; behind all where none adds anything. */
  std::size_t addingMost() const {
    std::size_t best = runs_.size(), most = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (isChosen_[i]) continue;
      const std::size_t added = addedBy(i);
      if (added > most && isCandidate(i) && !isOfChosenDrive(i)) best = i, most = added;
    }
    return best;
  }

  const std::vector<const Run*>& runs_;
  const std::vector<SeenPlaces>& seen_;
  std::vector<bool> isChosen_;
  std::vector<std::size_t> chosen_;
  std::unordered_set<std::int64_t> worth_;   // places that at least two runs have seen
  SeenCounts counts_;                        // by those that are chosen
  std::unordered_set<std::uint64_t> scans_;  // of those that are chosen
};

/** Calls with the index in `seen` of each place that both have; both are ascending. */
template <class Call>
void forEachShared(const SeenPlaces& seen, const SeenPlaces& other, const Call& call) {
  for (std::size_t i = 0, j = 0; i < seen.size() && j < other.size();) {
    if (seen[i] == other[j]) call(i);
    if (seen[i] <= other[j])
      ++i;
    else
      ++j;
  }
}

}  // namespace

SeenPlaces seenPlaces(const WallMap& map, const Transform2D& pose) {
  SeenPlaces places;
  for (const std::uint32_t cell : map.freeCells) {
    const Point place = pose(map.placeOf(cell));
    places.push_back(squareAt(place.x) * (std::int64_t(1) << 32) + squareAt(place.y));
  }
  sortUnique(places);
  return places;
}

std::vector<std::size_t> chooseCore(const std::vector<const Run*>& runs,
                                    const std::vector<SeenPlaces>& seen, std::size_t count,
                                    std::size_t fixed) {
  return Choosing(runs, seen).chosen(count, fixed);
}

std::vector<std::size_t> chooseJudges(const SeenPlaces& seen, const std::vector<SeenPlaces>& core,
                                      std::size_t count, std::size_t fixed) {
  std::vector<double> worth(seen.size(), 1);  // of each place
  std::vector<bool> isChosen(core.size());
  std::vector<std::size_t> chosen;
  const auto choose = [&](std::size_t judge) {
    chosen.push_back(judge);
    isChosen[judge] = true;
    forEachShared(seen, core[judge], [&](std::size_t i) { worth[i] /= 2; });
  };
  for (std::size_t i = 0; i < std::min(fixed, core.size()); ++i) choose(i);
  while (chosen.size() < count) {
    double most = 0;
    std::size_t best = 0;
    for (std::size_t judge = 0; judge < core.size(); ++judge) {
      if (isChosen[judge]) continue;
      double sum = 0;
      forEachShared(seen, core[judge], [&](std::size_t i) { sum += worth[i]; });
      if (sum > most) most = sum, best = judge;
    }
    if (most <= 0) break;
    choose(best);
  }
  return chosen;
}

std::vector<std::size_t> byStraightness(const std::vector<Run>& runs) {
  double largest = 0;
  for (const Run& run : runs) largest = std::max(largest, run.map.freeArea);
  std::vector<std::size_t> order = numbersFrom(0, runs.size());
  sortBy(order, [&](std::size_t i) {
    return std::make_pair(runs[i].map.freeArea < largest / 2,
                          runs[i].map.axisDeviation.value_or(M_PI));
  });
  return order;
}

}  // namespace roomgraph
