#include "roomgraph/check/find_revisits.h"

#include <optional>

#include "Passes.h"
#include "fitted_check.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

class Finder {
 public:
  Finder(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses)
      : scans_(scans), poses_(poses), passes_(scans, poses) {}

  std::vector<Revisit> find() {
    std::vector<Revisit> groups;
    for (const Pass& pass : passes_.all()) {
      std::optional<std::size_t> last;
      Transform2D lastShift;
      for (std::size_t k = 0; k < poses_.size(); ++k) {
        if (!isWanted(k, pass)) continue;
        const auto found = findIn(k, pass);
        if (!found) continue;
        const Transform2D moved = *found * poses_[k].inverse();
        const bool goesOn = last && passes_.pathBetween(*last, k) < Passes::kLength &&
                            areNear(moved, lastShift, poses_[k].shift(), kSteadyTrack);
        if (!goesOn) groups.emplace_back();
        last = k, lastShift = moved;
        groups.back().push_back(edgeTo(k, *found, pass));
      }
    }
    eraseIf(groups, [](const Revisit& group) { return group.size() < 2; });
    return groups;
  }

 private:
  bool isWanted(std::size_t k, const Pass& pass) const {
    const auto s = std::size_t(&pass - passes_.all().data());
    return contains(passes_.besideScan(k), s);
  }

  static bool isGood(const ScanFit& fit) {
    return fit.score >= fitted::kLeastScore && fit.quality >= kMajority &&
           fit.hold >= fitted::kLeastHold;
  }

  std::optional<Transform2D> findIn(std::size_t k, const Pass& pass) const {
    if (pass.map.walls.empty()) return std::nullopt;
    const ScanFit here = fitNear(scans_[k], pass.map, poses_[k]);
    if (here.quality >= kSureQuality && isGood(here)) return here.pose;
    const auto found = findScan(scans_[k], pass.map, poses_[k], passes_.windowOf(k, pass), 2);
    if (isGood(here) && (found.empty() || found.front().score < here.score / kRivalScore))
      return here.pose;
    if (found.empty() || !isGood(found.front())) return std::nullopt;
    if (found.size() > 1 && found[1].score > kRivalScore * found[0].score) return std::nullopt;
    return found.front().pose;
  }

  PoseEdge edgeTo(std::size_t k, const Transform2D& found, const Pass& pass) const {
    const std::size_t in = passes_.nearestScan(pass, found.shift());
    return matchEdge(NodeId(in), NodeId(k), poses_[in].inverse() * found, 1);
  }

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& poses_;
  Passes passes_;
};

}  // namespace

std::vector<Revisit> findRevisits(const std::vector<LocalScan>& scans,
                                  const std::vector<Transform2D>& poses) {
  return Finder(scans, poses).find();
}

}  // namespace roomgraph
