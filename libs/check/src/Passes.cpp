#include "Passes.h"

#include <algorithm>
#include <utility>

#include "fitted_check.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {

Passes::Passes(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses)
    : scans_(scans), poses_(poses), path_(poses.size()), beside_(poses.size()) {
  for (std::size_t k = 1; k < poses.size(); ++k)
    path_[k] = path_[k - 1] + distance(poses[k - 1].shift(), poses[k].shift());
  cut();
  for (std::size_t k = 0; k < poses.size(); ++k) chooseFor(k);
  for (Pass& pass : passes_) pass.map = scanMap(scans, poses, numbersFrom(pass.first, pass.end));
}

void Passes::cut() {
  std::size_t first = 0;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    const std::size_t count = k + 1 - first;
    const bool isFull = count >= kLeastScans && pathBetween(first, k) >= kLength;
    if (!isFull && count < fitted::kMostScans && k + 1 < poses_.size()) continue;
    passes_.push_back({first, k + 1, {}});
    first = k + 1;
  }
}

double Passes::pathTo(std::size_t k, const Pass& pass) const {
  return k < pass.first ? pathBetween(k, pass.first) : pathBetween(pass.end - 1, k);
}

std::size_t Passes::nearestScan(const Pass& pass, Point place) const {
  std::size_t nearest = pass.first;
  for (std::size_t i = pass.first; i < pass.end; ++i)
    if (distance(poses_[i].shift(), place) < distance(poses_[nearest].shift(), place)) nearest = i;
  return nearest;
}

PoseTolerance Passes::windowOf(std::size_t k, const Pass& pass) const {
  const double path = pathTo(k, pass);
  return {std::min(fitted::kMostWindow.turn, kSteadyTrack.turn + fitted::kDrift.turn * path),
          std::min(fitted::kMostWindow.place, kSteadyTrack.place + fitted::kDrift.place * path)};
}

void Passes::chooseFor(std::size_t k) {
  if (!scans_[k].isTelling()) return;
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t s = 0; s < passes_.size(); ++s) {
    const Pass& pass = passes_[s];
    const Point place = poses_[k].shift();  // from it to the robot's way there
    const double way = distance(poses_[nearestScan(pass, place)].shift(), place);
    const bool isOther = k + kLeastScans < pass.first || k >= pass.end + kLeastScans;
    if (isOther && pathTo(k, pass) > kWayRound && way < kLength / 2 + windowOf(k, pass).place)
      near.emplace_back(way, s);
  }
  std::sort(near.begin(), near.end());
  for (std::size_t i = 0; i < std::min(fitted::kMaps, near.size()); ++i)
    beside_[k].push_back(near[i].second);
}

}  // namespace roomgraph
