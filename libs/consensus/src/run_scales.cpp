#include "run_scales.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomgraph/base/majority.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {
namespace {

constexpr double kLeastApart = 0.005;  // of two sets of scales; bends make less
constexpr double kOfTheGap = 1.0 / 3;  // that the scales of a set may differ by
constexpr double kMostBent = 0.01;     // of the reach of a run, by more than its scale

/** How a run has drawn what lies at its nodes: the scale, and how far it reaches [m]. */
struct DrawnScale {
  RunId run;
  double scale = 1, reach = 0;
};

/** What of a map error the scale of its run does not add. */
double restOf(const MapError& error, const DrawnScale& own) {
  const double added = std::abs(own.scale - 1) * own.reach;
  return std::sqrt(std::max(0.0, error.error * error.error - added * added));
}

/** The similarity that lays the nodes of a run on the consensus (Umeyama 1991). */
std::optional<DrawnScale> scaleOf(const Consensus& consensus, RunId run) {
  const PoseGraph& graph = consensus.graph;
  double weight = 0;
  Point from, to;
  const auto each = [&](const auto& todo) {
    for (const NodeId id : graph.runs[run].nodes) {
      const PoseNode& node = graph.nodes[id];
      if (node.points.count > 0)
        todo(node.points.count, node.pose.shift(), consensus.poses[id].shift());
    }
  };
  each([&](double w, Point p, Point q) { weight += w, from = from + w * p, to = to + w * q; });
  if (weight <= 0) return std::nullopt;
  from = (1 / weight) * from, to = (1 / weight) * to;
  double cosine = 0, sine = 0, there = 0, drawn = 0;
  each([&](double w, Point p, Point q) {
    p = p - from, q = q - to;
    cosine += w * dot(p, q), sine += w * cross(p, q);
    there += w * squaredNorm(q), drawn += w * squaredNorm(p);
  });
  const double along = std::hypot(cosine, sine);
  if (along <= 0 || there <= 0) return std::nullopt;
  return DrawnScale{run, drawn / along, std::sqrt(drawn / weight)};
}

/** Where the scales, ascending, fall into two sets: the place of the first of the larger ones. */
std::optional<std::size_t> splitOf(const std::vector<DrawnScale>& scales) {
  if (scales.size() <= kFewestOthers) return std::nullopt;
  const auto gapBefore = [&](std::size_t i) { return scales[i].scale - scales[i - 1].scale; };
  std::size_t split = 1;
  for (std::size_t i = 2; i < scales.size(); ++i)
    if (gapBefore(i) > gapBefore(split)) split = i;
  const double gap = gapBefore(split);
  const double within = std::max(scales[split - 1].scale - scales.front().scale,
                                 scales.back().scale - scales[split].scale);
  const std::size_t smaller = std::min(split, scales.size() - split);
  if (gap < kLeastApart || within > kOfTheGap * gap) return std::nullopt;
  if (smaller == 1 && scales.size() > kFewestOthers + 1) return std::nullopt;
  return split;
}

double meanOf(const std::vector<DrawnScale>& scales, std::size_t first, std::size_t end) {
  double sum = 0;
  for (std::size_t i = first; i < end; ++i) sum += scales[i].scale;
  return sum / double(end - first);
}

/** Lets the interval hold the error by either scale: without what the own scale adds, and with what
 *  the other's would. */
void extend(MapError& error, const DrawnScale& own, double ownSet, double otherSet) {
  const double rest = restOf(error, own);
  const double share = error.error > 0 ? error.low / error.error : 1;
  const double ifRight = std::hypot(rest, std::abs(own.scale - ownSet) * own.reach);
  error.low = std::min(error.low, share * ifRight);
  const double ifOther = std::hypot(rest, std::abs(own.scale - otherSet) * own.reach);
  error.high = std::max(error.high, ifOther + std::max(0.0, error.high - error.error));
}

}  // namespace

void tellScales(Consensus& consensus) {
  std::vector<DrawnScale> scales;
  if (consensus.graph.reference) return;
  for (const RunId run : consensus.graph.runs.ids()) {
    MapError& error = consensus.errors[run];
    if (!consensus.graph.runs[run].hasScans || error.seen <= 0 || error.confirmed < kMajority)
      continue;
    const auto found = scaleOf(consensus, run);
    if (!found) continue;
    error.scale = found->scale;
    if (restOf(error, *found) <= kMostBent * found->reach) scales.push_back(*found);
  }
  std::stable_sort(scales.begin(), scales.end(),
                   [](const DrawnScale& l, const DrawnScale& r) { return l.scale < r.scale; });
  const auto split = splitOf(scales);
  if (!split) return;
  const double small = meanOf(scales, 0, *split), large = meanOf(scales, *split, scales.size());
  for (std::size_t i = 0; i < scales.size(); ++i) {
    MapError& error = consensus.errors[scales[i].run];
    const bool isLarge = i >= *split;
    error.scaleSet = isLarge ? ScaleSet::larger : ScaleSet::smaller;
    extend(error, scales[i], isLarge ? large : small, isLarge ? small : large);
  }
}

}  // namespace roomgraph
