#include "roomgraph/consensus/match_nodes.h"

#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "fitted_consensus.h"
#include "look_again.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/consensus/track_scans.h"

namespace roomgraph {
namespace {

/** Counts which nodes of the other run drew the walls that a node meets there. */
class Meeting {
 public:
  Meeting(const DrawnMap& other, const Transform2D& pose) : other_(other), forth_(pose) {}

  void add(const WallPoint& point) {
    ++all_;
    const Point place = forth_(point.place);
    const WallPoint* wall = nearestWall(other_.map, place, forth_.turned(point.normal));
    if (!wall || distance(wall->place, place) > kSameWall) return;
    ++found_;
    const auto first = other_.drawnBy.firsts.begin() + (wall - other_.map.walls.data());
    for (std::uint32_t k = first[0]; k < first[1]; ++k) ++met_[other_.drawnBy.nodes[k]];
  }

  double share() const { return all_ > 0 ? found_ / all_ : 0; }

  /** The node met most, of equal ones the first; none where nothing was met. */
  NodeId mostMet() const {
    NodeId most;
    for (const auto& [node, count] : met_)
      if (!most || count > met_.at(most)) most = node;
    return most;
  }

 private:
  const DrawnMap& other_;
  Motion2D forth_;
  double all_ = 0, found_ = 0;
  std::map<NodeId, int> met_;
};

/** Adds the match of a node that lies at `pose` (map <- run), if enough of it is there. */
void addMatch(const PoseGraph& graph, NodeId node, const Transform2D& pose, const Meeting& meeting,
              std::vector<PoseEdge>& matches) {
  const NodeId from = meeting.mostMet();
  if (!from || meeting.share() < fitted::kLeastQuality) return;
  const Transform2D measured = graph.nodes[from].pose.inverse() * pose * graph.nodes[node].pose;
  matches.push_back(matchEdge(from, node, measured, meeting.share()));
}

std::vector<FoundGroup> matchPatches(const PoseGraph& graph, RunId id, const WallMap& map,
                                     const DrawnMap& other, const FollowedWalls& followed) {
  std::map<int, FoundGroup> layers;
  for (const FollowedPatch& patch : followed.patches) {
    Meeting meeting(other, patch.pose);
    for (const std::uint32_t wall : map.patches[patch.patch].own) meeting.add(map.walls[wall]);
    addMatch(graph, graph.runs[id].nodes[patch.patch], patch.pose, meeting,
             layers[patch.layer].matches);
  }
  std::vector<FoundGroup> groups;
  for (auto& [layer, group] : layers) groups.push_back(std::move(group));
  return groups;
}

using Track = std::vector<std::optional<Transform2D>>;  // map <- run, of each scan

std::vector<FoundGroup> matchTrack(const PoseGraph& graph, IdRange<NodeId> nodes, const Run& run,
                                   const DrawnMap& other, const Track& track) {
  std::vector<FoundGroup> groups;
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (!track[k]) continue;
    const ScanWalls& scan = run.scans[k];
    if (!last || !areNear(*track[*last], *track[k], scan.robot(), kSteadyTrack))
      groups.emplace_back();  // the track jumps
    last = k;
    Meeting meeting(other, *track[k]);
    for (const WallPoint& point : scan.walls) meeting.add(point);
    addMatch(graph, nodes[k], *track[k], meeting, groups.back().matches);
  }
  return groups;
}

/** The track of a run; once more with where it may lie by what was not found. */
Track trackIn(const Run& run, const WallMap& map, const FollowedWalls& followed,
              const std::vector<Transform2D>& wholes) {
  TrackedFits fits;
  LikelyPoses likely{wholes, {}};
  Track track = trackScans(run.scans, run.map.patches, followed, likely, map, fits);
  likely.lost = lookAgain(run.scans, track, map);
  if (likely.lost.empty()) return track;
  return trackScans(run.scans, run.map.patches, followed, likely, map, fits);
}

/** What was found, between two runs. */
std::vector<FoundGroup> between(RunId from, RunId to, std::vector<FoundGroup> groups) {
  eraseIf(groups, [](const FoundGroup& group) { return group.matches.empty(); });
  for (FoundGroup& found : groups) found.group.from = from, found.group.to = to;
  return groups;
}

using Drawn = std::vector<std::pair<std::uint32_t, NodeId>>;  // wall point, node

Drawn drawnInScans(const std::vector<ScanWalls>& scans, IdRange<NodeId> nodes, const WallMap& map) {
  Drawn drawn;
  for (const NodeId node : nodes)
    for (const WallPoint& point : scans[nodes.placeOf(node)].walls) {
      const WallPoint* wall = nearestWall(map, point.place, point.normal);
      if (wall && distance(wall->place, point.place) < kSameWall)
        drawn.emplace_back(std::uint32_t(wall - map.walls.data()), node);
    }
  return drawn;
}

Drawn drawnInPatches(const WallPatches& patches, IdRange<NodeId> nodes) {
  Drawn drawn;
  for (const NodeId node : nodes)
    for (const std::uint32_t wall : patches[nodes.placeOf(node)].own)
      drawn.emplace_back(wall, node);
  return drawn;
}

}  // namespace

std::vector<FoundGroup> matchNodes(const PoseGraph& graph, RunId id, const Run& run,
                                   const DrawnMap& other, const FollowedWalls& followed,
                                   const std::vector<Transform2D>& wholes) {
  if (followed.patches.empty()) return {};
  std::vector<FoundGroup> groups;
  if (!graph.runs[id].hasScans) {
    groups = matchPatches(graph, id, run.map, other, followed);
  } else {
    const IdRange<NodeId> nodes = graph.runs[id].nodes;
    const Track track = trackIn(run, other.map, followed, wholes);
    groups = matchTrack(graph, nodes, run, other, track);
  }
  return between(other.run, id, std::move(groups));
}

std::vector<FoundGroup> matchAgain(const PoseGraph& graph, RunId id, const Run& run,
                                   const DrawnMap& other, const NodePoses& poses) {
  const std::vector<LocalScan> scans = localScans(run.scans);
  const IdRange<NodeId> nodes = graph.runs[id].nodes;
  Track track(scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const Transform2D& pose = poses[nodes[k]];
    const NodeId nearest = nearestNode(graph.runs[other.run].nodes, poses, pose.shift());
    if (!nearest || distance(poses[nearest].shift(), pose.shift()) >= kPatchReach) continue;
    const Transform2D start = graph.nodes[nearest].pose * poses[nearest].inverse() * pose;
    const ScanFit fit = fitNear(scans[k], other.map, start);
    if (areNear(fit.pose, start, {}, kRoughly)) track[k] = fit.pose * run.scans[k].pose.inverse();
  }
  return between(other.run, id, matchTrack(graph, nodes, run, other, track));
}

FoundGroup sameScans(const PoseGraph& graph, RunId a, const Run& runA, RunId b, const Run& runB) {
  std::unordered_map<std::uint64_t, std::size_t> scansOfB;
  for (std::size_t k = 0; k < runB.scans.size(); ++k)
    if (runB.scans[k].ends.count > 0) scansOfB.emplace(runB.scans[k].scanId, k);
  FoundGroup found{{b, a, {}}, {}};
  for (std::size_t k = 0; k < runA.scans.size(); ++k) {
    const auto same = scansOfB.find(runA.scans[k].scanId);
    if (runA.scans[k].ends.count > 0 && same != scansOfB.end())
      found.matches.push_back(
          sameScanEdge(graph.runs[b].nodes[same->second], graph.runs[a].nodes[k]));
  }
  return found;
}

DrawnBy drawnBy(const Run& run, IdRange<NodeId> nodes, const WallMap& map) {
  Drawn drawn =
      run.scans.empty() ? drawnInPatches(map.patches, nodes) : drawnInScans(run.scans, nodes, map);
  sortUnique(drawn);
  DrawnBy result;
  for (std::size_t next = 0, wall = 0; wall <= map.walls.size(); ++wall) {
    while (next < drawn.size() && drawn[next].first < wall) ++next;
    result.firsts.push_back(std::uint32_t(next));
  }
  for (const auto& [wall, node] : drawn) result.nodes.push_back(node);
  return result;
}

}  // namespace roomgraph
