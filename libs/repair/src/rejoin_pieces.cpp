#include "roomgraph/repair/rejoin_pieces.h"

#include <algorithm>

#include "OtherWalls.h"
#include "fitted_repair.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/StepWitness.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

class Rejoiner {
 public:
  Rejoiner(const SolvedSite& solved, const std::vector<Transform2D>& poses, std::size_t run)
      : solved_(solved),
        run_(run),
        scans_(solved.site.runs[run]->scans),
        poses_(poses),
        local_(localScans(scans_)),
        drawn_(drawnPoses(scans_)) {}

  std::vector<Transform2D> rejoined() {
    std::vector<std::pair<double, std::size_t>> tears;  // the largest first
    for (std::size_t k = 1; k < scans_.size(); ++k)
      if (isTorn(k)) tears.emplace_back(-poseDistance(offAt(k), {}), k);
    std::sort(tears.begin(), tears.end());
    for (const auto& [size, tear] : tears) rejoin(tear);
    return poses_;
  }

 private:
  Transform2D step(std::size_t k) const { return scans_[k - 1].pose.inverse() * scans_[k].pose; }

  /** How a scan lies off from where the link of the one before has it. */
  Transform2D offAt(std::size_t k) const { return (poses_[k - 1] * step(k)).inverse() * poses_[k]; }

  /** So far that it may lie in a look-alike place: of what is nearer the consensus knows best. */
  bool isTorn(std::size_t k) const { return !areNear(offAt(k), {}, {}, kRoughly); }

  /** Moves the smaller part beside a tear to where its links have it, unless that fits worse. The
   *  parts reach to the larger tears that are confirmed. */
  void rejoin(std::size_t tear) {
    const auto next = std::lower_bound(confirmed_.begin(), confirmed_.end(), tear);
    const std::size_t from = next == confirmed_.begin() ? 0 : *std::prev(next);
    const std::size_t to = next == confirmed_.end() ? scans_.size() : *next;
    const bool isLater = to - tear < tear - from;
    const Transform2D before = poses_[tear - 1] * step(tear);
    const Transform2D motion =
        isLater ? before * poses_[tear].inverse() : poses_[tear] * before.inverse();
    if (!witness_.refutes(tear, poses_[tear - 1].inverse() * poses_[tear]) &&
        isConfirmed(isLater ? tear : from, isLater ? to : tear, motion)) {
      confirmed_.insert(next, tear);
      return;
    }
    for (std::size_t k = isLater ? tear : from; k < (isLater ? to : tear); ++k)
      poses_[k] = motion * poses_[k];
  }

  /** Whether some scans fit clearly better where they lie than moved by `motion`. */
  bool isConfirmed(std::size_t first, std::size_t end, const Transform2D& motion) const {
    std::vector<std::size_t> probes;
    std::vector<Point> places;
    for (std::size_t i = 0; i < std::min(fitted::kProbes, end - first); ++i) {
      probes.push_back(first + i * (end - first) / std::min(fitted::kProbes, end - first));
      places.push_back(poses_[probes.back()].shift());
      places.push_back(motion(places.back()));
    }
    const OtherWalls walls(solved_, run_, places);
    double torn = 0, joined = 0;
    for (const std::size_t k : probes) {
      torn += walls.near(local_[k], poses_[k]).score;
      joined += walls.near(local_[k], motion * poses_[k]).score;
    }
    return joined < kRivalScore * torn;
  }

  const SolvedSite& solved_;
  std::size_t run_;
  const std::vector<ScanWalls>& scans_;
  std::vector<Transform2D> poses_;
  std::vector<std::size_t> confirmed_;  // tears, ascending
  std::vector<LocalScan> local_;
  std::vector<Transform2D> drawn_;
  StepWitness witness_{local_, drawn_};
};

}  // namespace

std::vector<Transform2D> rejoinPieces(const SolvedSite& solved,
                                      const std::vector<Transform2D>& poses, std::size_t run) {
  return Rejoiner(solved, poses, run).rejoined();
}

RealPoses rejoinPieces(const SolvedSite& solved) {
  RealPoses all(solved.site.runs.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!solved.site.runs[i]->scans.empty())
      all[i] = rejoinPieces(solved, solved.consensus.posesOf(i), i);
  return all;
}

}  // namespace roomgraph
