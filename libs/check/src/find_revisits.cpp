#include "roomgraph/check/find_revisits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace roomgraph {
namespace {

constexpr double kStretch = 8;  // path of the scans that draw one map [m]
constexpr std::size_t kLeastScans = 3, kMostScans = 12;
constexpr double kApart = 12;     // least path between a scan and those that it is held against [m]
constexpr double kRange = 15;     // [m]
constexpr double kBeside = 4;     // from a scan to the robot's way through a map [m]
constexpr std::size_t kMaps = 2;  // in which a scan is looked for
constexpr double kSureRevisit = 0.7;
constexpr double kLeastScore = 8, kRevisitQuality = 0.5, kLeastHold = 0.08;
constexpr double kDriftPlace = 0.02, kDriftTurn = 0.003;  // per metre of path
constexpr PoseTolerance kLeastWindow{0.1, 0.6}, kMostWindow{0.5, 3};

/** A stretch of the run, and what it has drawn. */
struct Stretch {
  std::size_t first = 0, end = 0;  // scans
  WallMap map;
};

class Finder {
 public:
  Finder(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses)
      : scans_(scans), poses_(poses), path_(poses.size()) {
    for (std::size_t k = 1; k < poses.size(); ++k)
      path_[k] = path_[k - 1] + distance(poses[k - 1].shift(), poses[k].shift());
    cut();
  }

  std::vector<Revisit> find() {
    std::vector<Revisit> groups;
    for (Stretch& stretch : stretches_) {
      std::optional<std::size_t> last;
      Transform2D lastShift;
      for (std::size_t k = 0; k < poses_.size(); ++k) {
        if (!isWanted(k, stretch)) continue;
        const auto found = findIn(k, stretch);
        if (!found) continue;
        const Transform2D moved = *found * poses_[k].inverse();
        const bool goesOn = last && path_[k] - path_[*last] < kStretch &&
                            areNear(moved, lastShift, poses_[k].shift(), kSteadyTrack);
        if (!goesOn) groups.emplace_back();
        last = k, lastShift = moved;
        groups.back().push_back(edgeTo(k, *found, stretch));
      }
    }
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const Revisit& group) { return group.size() < 2; }),
                 groups.end());
    return groups;
  }

 private:
  void cut() {
    std::size_t first = 0;
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const std::size_t count = k + 1 - first;
      const bool isFull = count >= kLeastScans && path_[k] - path_[first] >= kStretch;
      if (!isFull && count < kMostScans && k + 1 < poses_.size()) continue;
      stretches_.push_back({first, k + 1, {}});
      first = k + 1;
    }
    wanted_.resize(poses_.size());
    for (std::size_t k = 0; k < poses_.size(); ++k) chooseFor(k);
    for (Stretch& stretch : stretches_) {
      std::vector<std::size_t> chosen(stretch.end - stretch.first);
      std::iota(chosen.begin(), chosen.end(), stretch.first);
      stretch.map = scanMap(scans_, poses_, chosen, kRange);
    }
  }

  double pathTo(std::size_t k, const Stretch& stretch) const {
    return k < stretch.first ? path_[stretch.first] - path_[k] : path_[k] - path_[stretch.end - 1];
  }

  double wayTo(std::size_t k, const Stretch& stretch) const {
    double least = 1e9;
    for (std::size_t i = stretch.first; i < stretch.end; ++i)
      least = std::min(least, distance(poses_[i].shift(), poses_[k].shift()));
    return least;
  }

  PoseTolerance windowOf(double path) const {
    return {std::min(kMostWindow.turn, kLeastWindow.turn + kDriftTurn * path),
            std::min(kMostWindow.place, kLeastWindow.place + kDriftPlace * path)};
  }

  /** The maps in which a scan is looked for: the nearest ones that were drawn at other times. */
  void chooseFor(std::size_t k) {
    if (!scans_[k].isTelling()) return;
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t s = 0; s < stretches_.size(); ++s) {
      const double path = pathTo(k, stretches_[s]), way = wayTo(k, stretches_[s]);
      const bool isOther =
          k + kLeastScans < stretches_[s].first || k >= stretches_[s].end + kLeastScans;
      if (isOther && path > kApart && way < kBeside + windowOf(path).place)
        near.emplace_back(way, s);
    }
    std::sort(near.begin(), near.end());
    for (std::size_t i = 0; i < std::min(kMaps, near.size()); ++i)
      wanted_[k].push_back(near[i].second);
  }

  bool isWanted(std::size_t k, const Stretch& stretch) const {
    const auto s = std::size_t(&stretch - stretches_.data());
    return std::find(wanted_[k].begin(), wanted_[k].end(), s) != wanted_[k].end();
  }

  static bool isGood(const ScanFit& fit) {
    return fit.score >= kLeastScore && fit.quality >= kRevisitQuality && fit.hold >= kLeastHold;
  }

  std::optional<Transform2D> findIn(std::size_t k, const Stretch& stretch) const {
    if (stretch.map.walls.empty()) return std::nullopt;
    const ScanFit here = fitNear(scans_[k], stretch.map, poses_[k]);
    if (here.quality >= kSureRevisit && isGood(here)) return here.pose;
    const auto found = findScan(scans_[k], stretch.map, poses_[k], windowOf(pathTo(k, stretch)), 2);
    if (isGood(here) && (found.empty() || found.front().score < here.score / kRivalScore))
      return here.pose;
    if (found.empty() || !isGood(found.front())) return std::nullopt;
    if (found.size() > 1 && found[1].score > kRivalScore * found[0].score) return std::nullopt;
    return found.front().pose;
  }

  PoseEdge edgeTo(std::size_t k, const Transform2D& found, const Stretch& stretch) const {
    std::size_t in = stretch.first;
    for (std::size_t i = stretch.first; i < stretch.end; ++i)
      if (distance(poses_[i].shift(), found.shift()) < distance(poses_[in].shift(), found.shift()))
        in = i;
    return matchEdge(NodeId(in), NodeId(k), poses_[in].inverse() * found, 1);
  }

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& poses_;
  std::vector<double> path_;  // to each scan [m]
  std::vector<Stretch> stretches_;
  std::vector<std::vector<std::size_t>> wanted_;  // of each scan: stretches
};

}  // namespace

std::vector<Revisit> findRevisits(const std::vector<LocalScan>& scans,
                                  const std::vector<Transform2D>& poses) {
  return Finder(scans, poses).find();
}

}  // namespace roomgraph
