#include "roomgraph/repair/rejoin_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/breaks/MapBreak.h"

namespace roomgraph {
namespace {

constexpr std::size_t kScansAtTear = 8;       // beside a tear, that are looked up
constexpr double kBornOutBy = 0.15;           // share of walls that bears a tear out
constexpr double kIndexCell = 2 * kSameWall;  // of the index [m]

/** All walls that the runs but one have seen, where they really lie. */
class OtherWalls {
 public:
  OtherWalls(const SolvedSite& solved, std::size_t but) {
    for (std::size_t i = 0; i < solved.site.runs.size(); ++i) {
      if (i == but || solved.maps.firstOf(i) == solved.maps.firstOf(but)) continue;
      const std::vector<ScanWalls>& scans = solved.site.runs[i]->scans;
      const std::vector<Transform2D> poses = solved.posesOf(i);
      for (std::size_t k = 0; k < scans.size(); ++k) {
        const Motion2D there(poses[k] * scans[k].pose.inverse());
        for (const WallPoint& wall : scans[k].walls) cells_.insert(keyOf(there(wall.place)));
      }
    }
  }

  /** Share of the walls of a scan that lie beside such walls, if it lies at `pose`. */
  double share(const ScanWalls& scan, const Transform2D& pose) const {
    if (scan.walls.empty()) return 0;
    const Motion2D there(pose * scan.pose.inverse());
    const auto found =
        std::count_if(scan.walls.begin(), scan.walls.end(), [&](const WallPoint& wall) {
          const Point p = there(wall.place);
          for (const double x : {-kSameWall, kSameWall})
            for (const double y : {-kSameWall, kSameWall})
              if (cells_.count(keyOf(p + Point{x, y})) > 0) return true;
          return false;
        });
    return double(found) / double(scan.walls.size());
  }

 private:
  static std::int64_t keyOf(Point p) {
    constexpr std::int64_t row = std::int64_t(1) << 32;
    return std::int64_t(std::floor(p.y / kIndexCell)) * row +
           std::int64_t(std::floor(p.x / kIndexCell));
  }

  std::unordered_set<std::int64_t> cells_;
};

class Rejoiner {
 public:
  Rejoiner(const SolvedSite& solved, const std::vector<Transform2D>& poses, std::size_t run)
      : solved_(solved), run_(run), scans_(solved.site.runs[run]->scans), poses_(poses) {}

  std::vector<Transform2D> rejoined() {
    for (std::size_t k = 1; k < scans_.size(); ++k)
      if (isTorn(k)) tears_.push_back(k);
    for (std::size_t t = 0; t < tears_.size(); ++t) rejoin(t);
    return poses_;
  }

 private:
  Transform2D step(std::size_t k) const { return scans_[k - 1].pose.inverse() * scans_[k].pose; }

  bool isTorn(std::size_t k) const {
    const Transform2D off = (poses_[k - 1] * step(k)).inverse() * poses_[k];
    return norm(off.shift()) > kBreakShift || std::abs(off.phi) > kBreakRotation;
  }

  /** Moves the smaller part beside a tear to where its links have it, unless that fits worse. */
  void rejoin(std::size_t t) {
    const std::size_t tear = tears_[t];
    if (!isTorn(tear)) return;
    const std::size_t from = t == 0 ? 0 : tears_[t - 1];
    const std::size_t to = t + 1 == tears_.size() ? scans_.size() : tears_[t + 1];
    const bool isLater = to - tear < tear - from;
    const Transform2D before = poses_[tear - 1] * step(tear);
    const Transform2D motion =
        isLater ? before * poses_[tear].inverse() : poses_[tear] * before.inverse();
    const std::size_t first = isLater ? tear : tear - std::min(kScansAtTear, tear - from);
    const std::size_t last = isLater ? tear + std::min(kScansAtTear, to - tear) : tear;
    if (!walls_) walls_.emplace(solved_, run_);
    double torn = 0, joined = 0;
    for (std::size_t k = first; k < last; ++k) {
      torn += walls_->share(scans_[k], poses_[k]);
      joined += walls_->share(scans_[k], motion * poses_[k]);
    }
    if (torn > joined + kBornOutBy * double(last - first)) return;
    for (std::size_t k = isLater ? tear : from; k < (isLater ? to : tear); ++k)
      poses_[k] = motion * poses_[k];
  }

  const SolvedSite& solved_;
  std::size_t run_;
  const std::vector<ScanWalls>& scans_;
  std::vector<Transform2D> poses_;
  std::vector<std::size_t> tears_;
  std::optional<OtherWalls> walls_;
};

}  // namespace

std::vector<Transform2D> rejoinPieces(const SolvedSite& solved,
                                      const std::vector<Transform2D>& poses, std::size_t run) {
  return Rejoiner(solved, poses, run).rejoined();
}

RealPoses rejoinPieces(const SolvedSite& solved) {
  RealPoses all(solved.site.runs.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!solved.site.runs[i]->scans.empty()) all[i] = rejoinPieces(solved, solved.posesOf(i), i);
  return all;
}

}  // namespace roomgraph
