#pragma once
#include <cstddef>

#include "roomgraph/align/near_poses.h"

/** What the relation of runs was set by. What finds a map in another is judged by
 *  `benchmarks/alignment_accuracy --data DIR`, the choice of a core by `benchmarks/core_accuracy
 *  FOLDER...`, the scale of a picture by `benchmarks/scale_accuracy --data DIR`. */
namespace roomgraph::fitted {

// Following walls from patch to patch.
constexpr double kMinKnown = 0.4;  // share of them that lies where the other map has looked
constexpr int kTwinRounds = 2;
constexpr double kMinPieceShare = 0.03;  // share of the walls from which on a piece counts
constexpr int kMaxPieces = 6;
constexpr std::size_t kMaxCandidates = 40;       // poses that are tried for a piece
constexpr std::size_t kFewestContradicted = 60;  // walls that may be a stretch that is torn off
constexpr double kTornHold = 0.15;               // in both directions, unlike walls of one corridor
// Share of them that another part of the map has drawn, too: 0.21 to 0.55 of torn ends; of walls
// that a torn end has erased in the other map at most 0.11.
constexpr double kDrawnTwice = 0.2;

// Two maps.
constexpr double kUnlikely = 0.2;       // confidence below which an answer counts for nothing
constexpr std::size_t kMostOthers = 4;  // poses of a map in the hub: pieces; answers but the first
// How much better the mirror image must score: of sound maps it scores less by 0.9 or more.
constexpr double kClearlyMirrored = 0.7;

// Storeys of one building.
constexpr double kHardlyBent = 1;     // bend; storeys of one building lie within decimetres [m]
constexpr double kOtherWalls = 0.15;  // share of straight walls; of 88 pairs of one storey 0.07

// Runs of one drive, joined by their scans.
constexpr double kBendWidth = 1;    // how far off a scan counts half [m]
constexpr std::size_t kStarts = 8;  // scans along the drive whose walls are looked for

// Many runs: whom each is related to.
constexpr std::size_t kJudges = 4;   // runs of the core that any other run is related to
constexpr std::size_t kSeekers = 3;  // of them, in which is looked for what is not in the hub

// The core of many runs.
constexpr double kMuch = 0.02;  // of the places worth seeing, that one more run must add

// A pair beside the site.
constexpr double kAsGood = 0.8;  // of the walls found, to believe the site and not the pair

// The scale of a picture.
constexpr int kFits = 3;           // of the scale to the walls, each from the one before
constexpr int kMostAcross = 1500;  // cells that sizes are measured on
// Factors by which scales go below and above what sizes of rooms and map tell: what a run has not
// seen makes them look small; and farther still to reach the first guess.
constexpr double kBelow = 1.25, kAbove = 1.6, kGuessReach = 2;
constexpr std::size_t kCloser = 3;    // scales that are looked at closely
constexpr std::size_t kSearches = 2;  // runs that the picture is looked for in, until it fits one
constexpr std::size_t kVoters = 5;    // runs that have their say at last
constexpr double kUsualWidth = 0.4;   // median distance of free places to what is not free [m]
constexpr double kMinOfRun = 0.2;  // share of the run's free area that the picture must show, too

}  // namespace roomgraph::fitted
