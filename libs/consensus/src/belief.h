#pragma once
#include <vector>

#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

/** A match is borne out where the poses agree with it within this once the graph is solved; before,
 *  kRoughly will do. */
constexpr PoseTolerance kBorneOut = kSameAnswer;

/** Whether the poses of two submaps bear a match of them out. What both runs have scanned as one is
 *  the same place, whatever the poses say. */
bool isBorneOut(const SubmapMatch& match, const Transform2D& in, const Transform2D& of,
                const PoseTolerance& within);

/** The same of submaps that lie to each other as `found` (in <- of). */
bool isBorneOut(const SubmapMatch& match, const Transform2D& found, const PoseTolerance& within);

/** How far a piece is believed of whose matches this share is borne out, 0 to 1. In a building that
 *  repeats itself a run is found in the wrong wing as a whole, which is one mistake, however many
 *  scans it has. */
double beliefOf(double share);

/** What it costs to give up a piece, see docs/scoring.md, "Belief". Its matches are no independent
 *  witnesses, so it grows with the root of their number; and it says the less, the more the map
 *  looks alike elsewhere. */
double costOfGivingUp(const RunMatches& piece);

/** How far the poses let each piece be believed. */
std::vector<double> beliefIn(const std::vector<RunMatches>& matches, const SubmapPoses& poses,
                             const PoseTolerance& within);

/** What giving up pieces costs altogether. */
double costOfDisbelief(const std::vector<RunMatches>& matches, const std::vector<double>& belief);

}  // namespace roomgraph
