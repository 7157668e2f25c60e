#pragma once
#include <cstddef>

#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/PoseGraph.h"

/** The figures of the consensus. docs/method.md tells most of them, under the same headings, and a
 *  test holds it to these. They are round numbers, set so that the map errors and their intervals
 *  come out right where the truth is known: `benchmarks/score_accuracy --data DIR` shows what a
 *  change does. */
namespace roomgraph::fitted {

// The track of a run's scans through another map. Quality: share of a scan's walls that lie on
// walls.
constexpr double kSure = 0.75;          // from which on no other pose is tried
constexpr double kWell = 0.6;           // found well; else a scan is looked for at any turn
constexpr double kLeastQuality = 0.45;  // of a scan or node that is found; what a lost one is worth
constexpr double kJumpCost = 2;         // of a jump where the robot goes on from where it was
constexpr double kFarCost = 20;         // of a jump to another place
constexpr double kScanStride = 2.5;     // longest way from scan to scan [m]
constexpr std::size_t kMemory = 8;      // scans that may be lost between two that are found
constexpr std::size_t kCandidates = 4;  // poses of a scan, or of a stretch looked for again

// What a run's own scans say of its steps.
constexpr PoseTolerance kSlipped{0.35, 0.9};  // what ICP is wrong by where it slips
/** Scans on both sides of a step fit so much better otherwise that it is wrong as it was drawn. */
struct Contradiction {
  double mostAsDrawn, leastElsewhere;  // quality
  double leastGain;                    // walls
};
constexpr Contradiction kSlip{kLeastQuality, 0.52, 15}, kClearSlip{0.35, 0.42, 35},
    kTear{0.15, 0.4, 40};
// Share of a scan's walls, where the others of a step have looked, that can speak against it.
constexpr double kMaySpeak = 0.12;
// Of one scan in what those behind it have drawn, where that shows a slip: how much better it fits
// there than as it was drawn.
constexpr double kClearerBehind = 0.25, kGainBehind = 8;

// Links: some for each key frame, and more for the root of a metre, and of a radian [rad].
constexpr PoseNoise kLinkNoise{0.003, 0.02}, kLinkNoisePerRootMetre{0.004, 0.03};
constexpr double kLinkTurnPerRootRadian = 0.01;
// Matches. What both runs have scanned as one is twice as sure, and counts twice.
constexpr PoseNoise kMatchNoise{0.01, 0.06};
constexpr double kMatchWeight = 0.25;
// Walls of a node along the axes of the building [rad], and where these turn: by how much, between
// how many nodes on either side, and how many in the turn itself.
constexpr double kAxesTurn = 0.03, kAxesJump = 0.044;
constexpr std::size_t kBesideTurn = 5, kAcrossTurn = 2;
// The scales of robots usually differ by less; half of it is in the interval of each map error.
constexpr double kUsualStretch = 0.005;
// Of the kernels, in standard deviations.
constexpr double kLinkWidth = 3, kMatchWidth = 2, kAxesWidth = 6;
constexpr int kFirstWidening = 8;  // times as wide are those of links and matches at first

// A link that gives way though the run's own scans refute that: the weight that it gets, and how
// often this is asked.
constexpr double kHeldShare = 10;
constexpr int kHoldRounds = 3;

// Belief: what it costs to give up a group, for the root of its matches. With 25 of them it is half
// the robust squared residual of a link that is 20 m off.
constexpr double kGivingUp = 9;

// Slack: the least of a run that has its drive to itself, and of one that shares it.
constexpr double kLeastSlack = 0.1, kLeastSharedSlack = 0.4;
constexpr double kCountedLinks = 0.9;  // share of the links that count, those that give way least

// Map error: the interval is a factor, as a standard deviation of its log, and some metres.
constexpr double kFactor = 0.05, kFactorPerRun = 0.5, kFactorUnseen = 0.3;
constexpr double kMetresPerRun = 0.03;
constexpr long kLeastLostOnEnd = 3;     // one or two may be lost to people or glass, or at a break
constexpr double kUsualJitter = 0.03;   // of scans of a sound run, by what their walls scatter [m]
constexpr double kJitterFactor = 1.25;  // to either side, of what is more than that
constexpr std::size_t kLongScans = 12;  // that others have to bear out, and do not
constexpr double kLongWay = 8;          // the same [m]
constexpr double kAboutAsGood = 1.25;   // cost of a solution that may be right, beside the best

}  // namespace roomgraph::fitted
