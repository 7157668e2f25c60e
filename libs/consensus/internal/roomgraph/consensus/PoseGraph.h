#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/base/ById.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** Standard deviations of a measured pose [rad, m]. */
struct PoseNoise {
  double turn = 0, place = 0;

  PoseNoise times(double factor) const { return {factor * turn, factor * place}; }
};

/** How far two poses lie apart [rad, m]. */
struct PoseGap {
  double turn = 0, place = 0;
};

/** A part of a run that is rigid in itself: a key frame with its scan or, of a run without scans, a
 *  patch of its walls. */
struct PoseNode {
  RunId run;
  Transform2D pose;              ///< run <- node, as the run has it
  PointSums points;              ///< what it drew [m, frame of the node]
  std::optional<ScanAxes> axes;  ///< of its walls [frame of the node]
  /** The scans on both sides of the step to it contradict that step. */
  bool isDoubtful = false;
};

/** Where one node was measured to lie in another: a link of two nodes of a run, which are to keep
 *  their pose to each other, or a match, which is one of a group. */
struct PoseEdge {
  NodeId from, to;
  Transform2D measured;     ///< from <- to
  PoseNoise noise;          ///< of it
  MatchGroupId group;       ///< none of a link
  double share = 1;         ///< of the walls of `to` that were found; how far a link holds
  bool isSameScan = false;  ///< both are one scan of one drive, so `measured` changes nothing
  /** Of a link: how far apart a robot can have its nodes, in one step [m]. */
  double reach = std::numeric_limits<double>::infinity();
};

/** A match, `share` of whose walls were found. */
PoseEdge matchEdge(NodeId from, NodeId to, const Transform2D& measured, double share);
/** A match of two nodes that have one scan. */
PoseEdge sameScanEdge(NodeId from, NodeId to);

/** An edge as one of its nodes sees it. */
struct HalfEdge {
  NodeId node, other;
  Transform2D measured;  ///< other <- node
};

/** What of one run was found in another in one go, or of a run in itself elsewhere: right or wrong,
 *  it is so together. Its edges lead from the nodes of `from` to those of `to` that were found. */
struct MatchGroup {
  RunId from, to;
  IdRange<PoseEdgeId> edges;  ///< ascending by `to`; at least one
};

/** A run in the graph. Key frames are linked each to the next, patches to those beside them. */
struct GraphRun {
  IdRange<NodeId> nodes;  ///< key frames in the order of the run, or patches
  IdRange<PoseEdgeId> links;
  bool hasScans = false;
  double stretch = 1;  ///< how long its links are for 1 m as drawn, as it may be too large
};

/** A pose for each node of a graph, site <- node. */
using NodePoses = ById<NodeId, Transform2D>;

/** The runs of a site as nodes and edges: what each run says of itself, and what was found of one
 *  in the other. Nodes and links stand in the order of the runs, the edges of the matches behind
 *  them, group by group. A group may join two runs, or two places of one. */
struct PoseGraph {
  ById<RunId, GraphRun> runs;
  ById<NodeId, PoseNode> nodes;
  ById<PoseEdgeId, PoseEdge> edges;
  ById<MatchGroupId, MatchGroup> groups;
  RunId reference;  ///< the run that is taken for the truth and stays as it is, or none

  RunId addRun(bool hasScans);
  /** A run of another graph with its nodes and links, but not its matches. */
  RunId addRun(const PoseGraph& other, RunId run);
  /** To the run that was added last. */
  NodeId addNode(const Transform2D& pose, const PointSums& points,
                 const std::optional<ScanAxes>& axes);
  /** Between two nodes of the run that was added last, which keep the pose that they have as far as
   *  the link holds, 0 to 1; `reach` as in PoseEdge. */
  void addLink(NodeId from, NodeId to, double share = 1,
               double reach = std::numeric_limits<double>::infinity());
  /** The edges need no `group`; once this was called, no run may be added. */
  void addGroup(MatchGroup group, const std::vector<PoseEdge>& matches);

  /** Whether it shows how large a run is: against a reference, or two other runs. */
  bool showsStretch(RunId run) const;
  /** Gives the links of a run their length as drawn, times this. O(links of the run). */
  void setStretch(RunId run, double stretch);
  /** The same of each run. */
  void setStretches(const ById<RunId, double>& stretches);

  /** The nodes where their runs have them. */
  NodePoses ownPoses() const;
  RunId runOf(NodeId node) const { return nodes[node].run; }
};

/** The node of some that lies next to a place, of equal ones the first; none of none. O(nodes). */
NodeId nearestNode(const IdRange<NodeId>& nodes, const NodePoses& poses, Point place);

/** How far the nodes of an edge lie from where it has them. */
inline PoseGap gapOf(const PoseEdge& edge, const NodePoses& poses) {
  const Transform2D found = poses[edge.from].inverse() * poses[edge.to];
  return {std::abs(wrappedAngle(found.phi - edge.measured.phi)),
          distance(found.shift(), edge.measured.shift())};
}

/** How far the edges of a graph are trusted. */
struct GraphTrust {
  ById<RunId, double> slack;          ///< how far the links of a run give way, 1 at first
  ById<MatchGroupId, double> belief;  ///< how far a group is taken for right, 0 to 1
};

/** Both views of an edge, that of `to` first. */
inline std::array<HalfEdge, 2> halvesOf(const PoseEdge& edge) {
  return {{{edge.to, edge.from, edge.measured}, {edge.from, edge.to, edge.measured.inverse()}}};
}

/** Adds a run to a graph that has no matches yet: its key frames where it has scans, else its wall
 *  patches. O(scans), or O(walls). */
RunId addRunNodes(const Run& run, PoseGraph& graph);

}  // namespace roomgraph
