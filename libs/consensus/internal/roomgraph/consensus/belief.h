#pragma once
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

/** A match is an inlier where the poses agree with it within this once the graph is solved; before,
 *  kRoughly will do. */
constexpr PoseTolerance kInlier = kSameAnswer;

/** Whether a match agrees with nodes that lie so far from where it has them. What both runs have
 *  scanned as one is the same place, whatever the poses say. */
inline bool isInlier(const PoseEdge& match, const PoseGap& gap, const PoseTolerance& within) {
  return match.isSameScan || (gap.turn < within.turn && gap.place < within.place);
}

/** How far a group is believed that is given up. */
constexpr double kGivenUp = 1e-3;

/** How far a group is believed of whose matches this share are inliers, kGivenUp to 1. In a
 *  building that repeats itself a run is found in the wrong wing as a whole, which is one mistake,
 *  however many scans it has. */
double beliefOf(double share);

/** What it costs to give up a group, see docs/method.md, "Belief". Its matches are no independent
 *  witnesses, so it grows with the root of their number. */
double costOfGivingUp(const MatchGroup& group);

/** How far the poses let each group be believed. */
ById<MatchGroupId, double> beliefIn(const PoseGraph& graph, const NodePoses& poses,
                                    const PoseTolerance& within);

/** The share of the matches between two runs that the poses contradict; 0 if there are none. */
double givenUpBetween(const PoseGraph& graph, const NodePoses& poses, RunId a, RunId b);

/** What giving up groups costs altogether. */
double costOfDisbelief(const PoseGraph& graph, const ById<MatchGroupId, double>& belief);

/** How far the links of each run gave way in `poses`, at most 1: the root of their mean squared
 *  residual, but for the tenth that gives way most (Foerstner 1979, one step). Patches hold each
 *  other many times over, so of them it counts only how runs compare. Runs that share their drive
 *  err alike, so theirs is no less than 0.4, that of others no less than 0.1. O(edges). */
ById<RunId, double> runSlack(const PoseGraph& graph, const NodePoses& poses);

}  // namespace roomgraph
