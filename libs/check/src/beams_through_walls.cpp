#include "roomgraph/check/beams_through_walls.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "Passes.h"
#include "fitted_check.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

bool isThrough(const WallMap& map, std::size_t cell, Point place, Point normal) {
  if (map.states[cell] != State::free) return false;
  const WallPoint* wall = nearestWall(map, cell, normal);
  return !wall || distance(wall->place, place) > kSameWhereBent;
}

/** What beams of a pass tell of the walls of one scan, which lies at `pose`. */
BeamsThroughWalls beamsOf(const LocalScan& scan, const WallMap& map, const Transform2D& pose) {
  BeamsThroughWalls beams;
  if (map.walls.empty()) return beams;
  const Motion2D forth(pose);
  for (const WallPoint& wall : scan.walls) {
    const Point place = forth(wall.place);
    const std::size_t cell = cellIndexAt(map.frame, place);
    if (!hasSeen(map, cell)) continue;
    ++beams.walls;
    beams.through += isThrough(map, cell, place, forth.turned(wall.normal));
  }
  return beams;
}

bool isOverlaid(const BeamsThroughWalls& beams) {
  return beams.walls >= LocalScan::kTelling &&
         double(beams.through) > kMajority * double(beams.walls);
}

std::size_t scansIn(const std::vector<ScanPair>& pairs) {
  std::set<std::size_t> scans;
  for (const ScanPair& pair : pairs) scans.insert({pair.one, pair.other});
  return scans.size();
}

bool areEnough(const std::vector<ScanPair>& pairs) {
  return pairs.size() >= fitted::kLeastPairs && scansIn(pairs) >= fitted::kLeastPairs;
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
    return anyOf(group, [&](const ScanPair& other) { return path.areBeside(pair, other); });
  });
  return beside;
}

}  // namespace

BeamsThroughWalls beamsThroughWalls(const std::vector<LocalScan>& scans,
                                    const std::vector<Transform2D>& poses) {
  const Passes passes(scans, poses);
  BeamsThroughWalls beams;
  for (std::size_t k = 0; k < scans.size(); ++k)
    for (const std::size_t s : passes.besideScan(k)) {
      const Pass& pass = passes.all()[s];
      const BeamsThroughWalls one = beamsOf(scans[k], pass.map, poses[k]);
      beams.walls += one.walls, beams.through += one.through;
      if (isOverlaid(one))
        beams.overlaid.push_back(scanPair(k, passes.nearestScan(pass, poses[k].shift())));
    }
  return beams;
}

bool seesThroughMore(const BeamsThroughWalls& drawn, const BeamsThroughWalls& agreed) {
  return drawn.share() && agreed.share() && *agreed.share() > fitted::kMoreBeams * *drawn.share();
}

std::vector<WeldedPlace> findWelded(const Run& run, const BeamsThroughWalls& drawn,
                                    const BeamsThroughWalls& agreed) {
  const PathOfRun path(run.scans);
  std::vector<std::vector<ScanPair>> groups = path.grouped(drawn.overlaid);
  sortDownBy(groups, [](const auto& group) { return group.size(); });
  std::vector<WeldedPlace> welded;
  for (const std::vector<ScanPair>& group : groups)
    if (areEnough(group) && areEnough(pairsBeside(group, agreed.overlaid, path)))
      welded.push_back(placeOf(group, run));
  return welded;
}

}  // namespace roomgraph
