#include "roomgraph/relate/estimate_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "choose_runs.h"
#include "fitted_relate.h"
#include "roomgraph/align/fit_scale.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** A scale, and how well the picture fits there. */
struct ScaleTrial {
  double resolution = 0;
  Alignment alignment;  ///< run <- picture
  double score() const { return alignment.best ? alignment.best->score : -HUGE_VAL; }
};

/** Whether the scales are no farther apart than those that are tried to the next but one. */
bool areSame(const ScaleTrial& l, const ScaleTrial& r) {
  return std::abs(std::log(l.resolution / r.resolution)) <= 2 * kScaleStep;
}

/** Sizes of a map that do not depend on how it is turned [m]; 0 where there is nothing. */
struct Sizes {
  double free = 0;   ///< root of the free area
  double width = 0;  ///< median distance of free places to what is not free
  double walls = 0;  ///< root mean square distance of the walls from their middle

  explicit Sizes(const WallMap& map) : free(std::sqrt(map.freeArea)) {
    std::vector<double> depths;
    for (std::size_t i = 0; i < map.depths.size(); ++i)
      if (map.states[i] == State::free) depths.push_back(map.depths[i]);
    if (depths.empty() || map.walls.empty()) return;
    width = median(std::move(depths));
    Point middle;
    for (const WallPoint& wall : map.walls)
      middle = middle + (1 / double(map.walls.size())) * wall.place;
    for (const WallPoint& wall : map.walls) walls += squaredNorm(wall.place - middle);
    walls = std::sqrt(walls / double(map.walls.size()));
  }
};

/** Of a picture, in cells. A large one is measured on coarser cells. */
Sizes sizesInCells(const Grid& picture) {
  const int factor = std::max(picture.frame.width, picture.frame.height) / fitted::kMostAcross + 1;
  Sizes sizes(wallMap(rescaled(coarser(rescaled(picture, 1), factor, 0), 1)));
  sizes.free *= factor, sizes.width *= factor, sizes.walls *= factor;
  return sizes;
}

/** The scales to try, rising: those that sizes of map and rooms make likely, and so many more that
 *  the first guess is among them. Where it lies does not change the others. */
std::vector<double> scalesToTry(const Grid& picture, const WallMap& run) {
  const Sizes cells = sizesInCells(picture), metres(run);
  if (cells.walls <= 0 || metres.walls <= 0) return {picture.frame.resolution};
  const auto [least, most] = std::minmax(
      {metres.free / cells.free, metres.width / cells.width, metres.walls / cells.walls});
  const double low = least / fitted::kBelow, high = most * fitted::kAbove;
  const double reach = std::log(fitted::kGuessReach);
  const double lower = std::clamp(std::log(low / picture.frame.resolution), 0.0, reach);
  const double higher = std::clamp(std::log(picture.frame.resolution / high), 0.0, reach);
  const int first = -int(std::ceil(lower / kScaleStep));
  const int last = int(std::ceil((std::log(high / low) + higher) / kScaleStep));
  std::vector<double> scales;
  for (int i = first; i <= last; ++i) scales.push_back(low * std::exp(i * kScaleStep));
  return scales;
}

ScaleTrial trialAt(double resolution, const Grid& picture, const WallMap& run,
                   const SearchEffort& effort = kFullSearch) {
  return {resolution, alignMaps(run, wallMap(rescaled(picture, resolution)), effort)};
}

/** From a scale that is nearly right, the one that fits the walls near the pose found there. */
ScaleTrial fitToWalls(const ScaleTrial& near, const Grid& picture, const WallMap& run) {
  double resolution = near.resolution;
  Transform2D pose = near.alignment.pose;
  for (int i = 0; i < fitted::kFits; ++i) {
    const WallMap map = wallMap(rescaled(picture, resolution));
    const ScaledPose fit = fitScale(run, map, pose, i == 0 ? 1.0 : 0.5);
    resolution *= fit.scale, pose = fit.pose;
  }
  return {resolution, alignMapsNear(run, wallMap(rescaled(picture, resolution)), {pose})};
}

/** All scales of the range, the best first; of equal ones the smaller scale. */
std::vector<ScaleTrial> tryScales(const Grid& picture, const WallMap& run, const ForEach& forEach) {
  const std::vector<double> scales = scalesToTry(picture, run);
  std::vector<ScaleTrial> trials(scales.size());
  forEach(trials.size(),
          [&](std::size_t i) { trials[i] = trialAt(scales[i], picture, run, kQuickSearch); });
  sortDownBy(trials, &ScaleTrial::score);
  return trials;
}

/** The best scale near `trial`: the best of some between it and its neighbours, fitted to the
 *  walls, then once more from the pose that is the best there. */
ScaleTrial lookCloser(const ScaleTrial& trial, const Grid& picture, const WallMap& run) {
  ScaleTrial best = trial;
  for (const int quarters : {-2, -1, 1, 2}) {
    const double resolution = trial.resolution * std::exp(quarters * kScaleStep / 4);
    ScaleTrial other = trialAt(resolution, picture, run, kQuickSearch);
    if (other.score() > best.score()) best = std::move(other);
  }
  const double resolution = fitToWalls(best, picture, run).resolution;
  best = trialAt(resolution, picture, run);
  ScaleTrial again = fitToWalls(best, picture, run);
  return again.score() > best.score() ? again : best;
}

/** The best scales that are not near a better one, looked at closely; the best first. */
std::vector<ScaleTrial> bestOf(const std::vector<ScaleTrial>& trials, const Grid& picture,
                               const WallMap& run, const ForEach& forEach) {
  std::vector<ScaleTrial> chosen = distinctBest(trials, fitted::kCloser, areSame);
  forEach(chosen.size(), [&](std::size_t i) { chosen[i] = lookCloser(chosen[i], picture, run); });
  sortDownBy(chosen, &ScaleTrial::score);
  return chosen;
}

/** Whether the picture shows enough of the run: a single room fits in many places, at any scale. */
bool isLargeEnough(const ScaleTrial& trial, const WallMap& run) {
  const double common = trial.alignment.best->evidence.common / 2;  // counted both ways
  return common >= fitted::kMinOfRun * run.freeArea;
}

/** The scale that stands out, if any. */
std::optional<ScaleTrial> foundIn(const Grid& picture, const WallMap& run, const ForEach& forEach) {
  const std::vector<ScaleTrial> trials = tryScales(picture, run, forEach);
  const std::vector<ScaleTrial> close = bestOf(trials, picture, run, forEach);
  const ScaleTrial& best = close.front();
  if (best.alignment.siteConfidence < kMinScaleConfidence || best.alignment.overlap < kMajority ||
      !isLargeEnough(best, run))
    return std::nullopt;
  for (const auto* others : {&trials, &close})
    for (const ScaleTrial& other : *others)
      if (!areSame(other, best) && other.score() > best.score() - kMinScaleMargin)
        return std::nullopt;
  return best;
}

/** What the runs `voters` say that the picture fits at about `found`; never empty. */
std::vector<ScaleTrial> collectVotes(const Grid& picture, const std::vector<Run>& runs,
                                     const std::vector<std::size_t>& voters,
                                     const ScaleTrial& found, std::size_t best,
                                     const ForEach& forEach) {
  const WallMap map = wallMap(rescaled(picture, found.resolution));
  std::vector<ScaleTrial> all(voters.size());
  forEach(voters.size(), [&](std::size_t i) {
    const WallMap& run = runs[voters[i]].map;
    if (voters[i] == best || run.walls.empty()) return;
    const ScaleTrial there{found.resolution, alignMaps(run, map, kQuickSearch)};
    all[i] = fitToWalls(there, picture, run);
  });
  eraseIf(all, [&](const ScaleTrial& vote) {
    return !vote.alignment.isSameSite || vote.alignment.overlap < kMajority ||
           !areSame(vote, found);
  });
  all.push_back(found);
  return all;
}

/** The median, each scale counting by its odds; of at least one. */
double consensusOf(const std::vector<ScaleTrial>& votes) {
  double most = -HUGE_VAL;
  for (const ScaleTrial& vote : votes) most = std::max(most, vote.score());
  return *weightedMedian(mapped(votes, [&](const ScaleTrial& vote) {
    return WeightedValue{vote.resolution, std::exp(vote.score() - most)};
  }));
}

}  // namespace

Grid rescaled(Grid grid, double resolution) {
  grid.frame.origin = (resolution / grid.frame.resolution) * grid.frame.origin;
  grid.frame.resolution = resolution;
  return grid;
}

std::optional<ScaleEstimate> estimateScale(const Grid& picture, const std::vector<Run>& runs,
                                           const ForEach& forEach) {
  std::size_t searches = 0;
  const std::vector<std::size_t> order = byStraightness(runs);
  const std::vector<std::size_t> voters(
      order.begin(), order.begin() + std::ptrdiff_t(std::min(order.size(), fitted::kVoters)));
  for (const std::size_t best : order) {
    const WallMap& run = runs[best].map;
    if (run.walls.empty()) continue;
    if (searches++ == fitted::kSearches) break;
    const auto found = foundIn(picture, run, forEach);
    if (!found) continue;
    const auto agreed = collectVotes(picture, runs, voters, *found, best, forEach);
    return ScaleEstimate{consensusOf(agreed), agreed.size()};
  }
  return std::nullopt;
}

std::optional<double> usualScale(const std::vector<Grid>& pictures) {
  std::vector<double> widths;
  for (const Grid& picture : pictures)
    if (const double width = sizesInCells(picture).width; width > 0) widths.push_back(width);
  if (widths.empty()) return std::nullopt;
  return fitted::kUsualWidth / median(std::move(widths));
}

}  // namespace roomgraph
