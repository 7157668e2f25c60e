#include "roomgraph/consensus/scans_of_step.h"

#include <algorithm>
#include <utility>

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr std::size_t kScansAhead = 8;   // that draw the map in which the next is looked for
constexpr std::size_t kScansBehind = 6;  // that draw the map in which those ahead are looked for

}  // namespace

ScanFit asDrawn(const LocalScan& scan, const WallMap& in, const Transform2D& drawn) {
  const ScanFit fit = fitNear(scan, in, drawn);
  return areNear(fit.pose, drawn, {}, kAsDrawn) ? fit : fitAt(scan, in, drawn);
}

WallMap ScansOfStep::ahead(std::size_t k, const std::vector<Transform2D>& poses) const {
  std::vector<std::size_t> chosen;
  for (std::size_t i = k; i-- > 0 && chosen.size() < kScansAhead;)
    if (scans_[i].isTelling()) chosen.push_back(i);
  return scanMap(scans_, poses, chosen, range_);
}

WallMap ScansOfStep::around(std::size_t k, const std::vector<Transform2D>& poses) const {
  const Point robot = poses[k - 1].shift();
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < k; ++i)
    if (scans_[i].isTelling()) near.emplace_back(distance(poses[i].shift(), robot), i);
  const std::size_t count = std::min(near.size(), 3 * kScansAhead);
  std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(near[i].second);
  return scanMap(scans_, poses, chosen, range_);
}

const WallMap& ScansOfStep::behind(std::size_t k) {
  if (behindOf_ == k) return behind_;
  behind_ = scanMap(scans_, posesFrom(k), numbersFrom(k, endBehind(k)), range_);
  behindOf_ = k;
  return behind_;
}

StepView ScansOfStep::view(std::size_t k, const std::vector<Transform2D>& poses) const {
  return {together(k - std::min(k, kTogether), k, poses),
          together(k, std::min(k + kTogether, scans_.size()), posesFrom(k))};
}

ScanFit ScansOfStep::weighed(std::size_t k, const StepView& view, ScanFit fit) {
  const ScanFit back = fitAt(view.before, behind(k), fit.pose.inverse());
  const double known = std::max(1e-9, fit.known + back.known);
  fit.quality = (fit.quality * fit.known + back.quality * back.known) / known;
  fit.score += back.score;
  fit.known = known / 2;
  return fit;
}

LocalScan ScansOfStep::together(std::size_t first, std::size_t end,
                                const std::vector<Transform2D>& poses) const {
  LocalScan all;
  for (std::size_t i = first; i < end; ++i) {
    const Motion2D forth(poses[i]);
    for (const WallPoint& wall : scans_[i].walls)
      if (norm(wall.place) < range_)
        all.walls.push_back({forth(wall.place), forth.turned(wall.normal)});
  }
  return all;
}

/** Where the scans lie of which that at `k` is the first, seen from it. */
std::vector<Transform2D> ScansOfStep::posesFrom(std::size_t k) const {
  std::vector<Transform2D> fromHere(scans_.size());
  for (std::size_t i = k; i < endBehind(k); ++i) fromHere[i] = step(k, i);
  return fromHere;
}

std::size_t ScansOfStep::endBehind(std::size_t k) const {
  return std::min(k + kScansBehind, scans_.size());
}

}  // namespace roomgraph
