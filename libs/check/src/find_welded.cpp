#include "find_welded.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace roomgraph {
namespace {

constexpr std::size_t kLeastPairs = 6;  // one or the other may have seen people, or through glass

std::size_t scansIn(const std::vector<ScanPair>& pairs) {
  std::set<std::size_t> scans;
  for (const ScanPair& pair : pairs) scans.insert({pair.one, pair.other});
  return scans.size();
}

bool areEnough(const std::vector<ScanPair>& pairs) {
  return pairs.size() >= kLeastPairs && scansIn(pairs) >= kLeastPairs;
}

WeldedPlace placeOf(const std::vector<ScanPair>& pairs, const Run& run) {
  const ScanPair& middle = pairs[pairs.size() / 2];
  return {stretchOf(run, pairs, &ScanPair::one, middle.one),
          stretchOf(run, pairs, &ScanPair::other, middle.other)};
}

/** Those of some pairs that lie beside one of a group. */
std::vector<ScanPair> pairsBeside(const std::vector<ScanPair>& group,
                                  const std::vector<ScanPair>& pairs, const PathOfRun& path) {
  std::vector<ScanPair> beside;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(beside), [&](const ScanPair& pair) {
    return std::any_of(group.begin(), group.end(),
                       [&](const ScanPair& other) { return path.areBeside(pair, other); });
  });
  return beside;
}

}  // namespace

std::vector<WeldedPlace> findWelded(const Run& run, const BeamsThroughWalls& drawn,
                                    const BeamsThroughWalls& agreed) {
  const PathOfRun path(run.scans);
  std::vector<std::vector<ScanPair>> groups = path.grouped(drawn.overlaid);
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& l, const auto& r) { return l.size() > r.size(); });
  std::vector<WeldedPlace> welded;
  for (const std::vector<ScanPair>& group : groups)
    if (areEnough(group) && areEnough(pairsBeside(group, agreed.overlaid, path)))
      welded.push_back(placeOf(group, run));
  return welded;
}

}  // namespace roomgraph
