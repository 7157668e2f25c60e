#include "roomgraph/consensus/PoseGraph.h"

#include <limits>

#include "fitted_consensus.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/consensus/gait.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {
namespace {

void addScans(const Run& run, PoseGraph& graph) {
  const Gait gait(drawnPoses(run.scans), mapped(run.scans, &ScanWalls::time));
  NodeId last;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const ScanWalls& scan = run.scans[k];
    const NodeId node = graph.addNode(scan.pose, scan.ends, scan.axes);
    if (last) graph.addLink(last, node, 1, gait.reachTo(k));
    last = node;
  }
}

void addPatches(const WallMap& map, PoseGraph& graph) {
  for (const WallPatch& patch : map.patches) {
    PointSums points;
    for (const std::uint32_t wall : patch.own) points.add(map.walls[wall].place - patch.middle);
    graph.addNode({patch.middle.x, patch.middle.y, 0}, points, std::nullopt);
  }
}

/** How far a step of an ordinary run is off: some for each key frame, and more for way and turn. */
PoseNoise linkNoise(const Transform2D& step) {
  const double way = norm(step.shift());
  const double turned = std::abs(step.phi);
  const auto squared = [](double x) { return x * x; };
  const auto& [turn, place] = fitted::kLinkNoise;
  const auto& [turnPerRoot, placePerRoot] = fitted::kLinkNoisePerRootMetre;
  return {std::sqrt(squared(turn) + squared(turnPerRoot) * way +
                    squared(fitted::kLinkTurnPerRootRadian) * turned),
          std::sqrt(squared(place) + squared(placePerRoot) * way)};
}

}  // namespace

RunId addRunNodes(const Run& run, PoseGraph& graph) {
  const RunId id = graph.addRun(!run.scans.empty());
  if (graph.runs[id].hasScans) {
    addScans(run, graph);
    return id;
  }
  addPatches(run.map, graph);
  const IdRange<NodeId> nodes = graph.runs[id].nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (const std::uint32_t next : run.map.patches[k].neighbours)
      if (next > k) graph.addLink(nodes[k], nodes[next]);
  return id;
}

NodeId nearestNode(const IdRange<NodeId>& nodes, const NodePoses& poses, Point place) {
  NodeId nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const NodeId node : nodes)
    if (const double far = squaredNorm(poses[node].shift() - place); far < least)
      nearest = node, least = far;
  return nearest;
}

PoseEdge matchEdge(NodeId from, NodeId to, const Transform2D& measured, double share) {
  return {from, to, measured, fitted::kMatchNoise, {}, share};
}

PoseEdge sameScanEdge(NodeId from, NodeId to) {
  return {from, to, {}, fitted::kMatchNoise.times(0.5), {}, 1, true};
}

RunId PoseGraph::addRun(bool hasScans) {
  return runs.add({{nodes.size(), nodes.size()}, {edges.size(), edges.size()}, hasScans});
}

RunId PoseGraph::addRun(const PoseGraph& other, RunId run) {
  const GraphRun& theirs = other.runs[run];
  const RunId id = addRun(theirs.hasScans);
  runs[id].stretch = theirs.stretch;
  const std::size_t firstNode = nodes.size(), firstLink = edges.size();
  const auto ours = [&](NodeId node) { return NodeId(firstNode + theirs.nodes.placeOf(node)); };
  for (const NodeId node : theirs.nodes) {
    nodes.add(other.nodes[node]);
    nodes[ours(node)].run = id;
  }
  for (const PoseEdgeId link : theirs.links) {
    PoseEdge edge = other.edges[link];
    edge.from = ours(edge.from), edge.to = ours(edge.to);
    edges.add(edge);
  }
  runs[id].nodes = {firstNode, nodes.size()}, runs[id].links = {firstLink, edges.size()};
  return id;
}

NodeId PoseGraph::addNode(const Transform2D& pose, const PointSums& points,
                          const std::optional<ScanAxes>& axes) {
  const RunId run = runs.ids().back();
  const NodeId node = nodes.add({run, pose, points, axes});
  runs[run].nodes = {nodes.size() - 1 - runs[run].nodes.size(), nodes.size()};
  return node;
}

void PoseGraph::addLink(NodeId from, NodeId to, double share, double reach) {
  const Transform2D step = nodes[from].pose.inverse() * nodes[to].pose;
  edges.add({from, to, step, linkNoise(step), {}, share, false, reach});
  GraphRun& run = runs[runOf(to)];
  run.links = {edges.size() - 1 - run.links.size(), edges.size()};
}

void PoseGraph::addGroup(MatchGroup group, const std::vector<PoseEdge>& matches) {
  group.edges = {edges.size(), edges.size() + matches.size()};
  const MatchGroupId id = groups.add(group);
  for (PoseEdge edge : matches) {
    edge.group = id;
    edges.add(edge);
  }
}

bool PoseGraph::showsStretch(RunId run) const {
  return runs[run].hasScans && run != reference && (reference || runs.size() > kFewestOthers);
}

void PoseGraph::setStretch(RunId run, double stretch) {
  const double by = stretch / runs[run].stretch;
  for (const PoseEdgeId link : runs[run].links)
    edges[link].measured.x *= by, edges[link].measured.y *= by;
  runs[run].stretch = stretch;
}

void PoseGraph::setStretches(const ById<RunId, double>& stretches) {
  for (const RunId run : runs.ids()) setStretch(run, stretches[run]);
}

NodePoses PoseGraph::ownPoses() const {
  NodePoses poses;
  for (const PoseNode& node : nodes) poses.add(node.pose);
  return poses;
}

}  // namespace roomgraph
