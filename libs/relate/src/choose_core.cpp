#include "choose_core.h"

#include <algorithm>
#include <unordered_set>

#include "fitted_relate.h"
#include "roomgraph/align/are_identical.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/shares_drive.h"

namespace roomgraph {
namespace {

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
    const auto same = std::count_if(scans.begin(), scans.end(), [&](const ScanWalls& scan) {
      return scans_.count(scan.scanId) > 0;
    });
    return sharesDrive(std::size_t(same), scans.size());
  }

  std::size_t addedBy(std::size_t run) const {
    const SeenPlaces& places = seen_[run];
    return std::size_t(std::count_if(places.begin(), places.end(), [&](std::int64_t place) {
      const auto count = counts_.find(place);
      return worth_.count(place) > 0 && (count == counts_.end() || count->second < kFewestOthers);
    }));
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

}  // namespace

std::vector<std::size_t> chooseCore(const std::vector<const Run*>& runs,
                                    const std::vector<SeenPlaces>& seen, std::size_t count,
                                    std::size_t fixed) {
  return Choosing(runs, seen).chosen(count, fixed);
}

}  // namespace roomgraph
