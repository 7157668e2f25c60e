#pragma once
#include <cstddef>
#include <cstdint>

/** What repair was set by: the runs that `benchmarks/score_accuracy --data DIR` compares, with what
 *  is left of their true errors once they are mended; see "Repair" and "Carry" in
 *  benchmarks/README.md. */
namespace roomgraph::fitted {

// The frame of a mended run.
constexpr double kWithin = 2.5 * 1.4826;  // medians: 2.5 standard deviations of normal errors

// Whether a run gets better.
constexpr std::size_t kProbes = 60;  // scans of it, or of a piece, by which it is judged, about
// An interval from less than this part of the error on holds two answers, as in a building that is
// symmetric: of one answer it begins at a third or more.
constexpr double kTwoWays = 5;

// One map of several runs.
constexpr double kWallShare = 0.4;       // of the votes, from which on a cell is wall
constexpr double kToldOf = 0.1;          // share of the beams of a scan that tells of all of it
constexpr double kMostAgainst = 0.25;    // share of those told that may contradict the others
constexpr double kBehindWall = 0.5;      // so far behind a wall nothing is seen that grazes it [m]
constexpr double kClearlyFree = 0.1;     // wall share up to which a cell is looked through
constexpr std::uint32_t kSureBeams = 3;  // from so many on a run has seen a cell well

// How a map bends round a place.
constexpr double kEarshot = 12;   // a node, or scan, says nothing of places farther away [m]
constexpr double kBlend = 1;      // over so much the word passes from node to node [m]
constexpr double kUnseen = 0.01;  // what a node's word is worth through a wall
// Who marks a place may mean what a node this near has drawn, or one twice as far off that sees it
// [m].
constexpr double kMeant = 3;
constexpr double kOtherPiece = 3;  // a piece lies elsewhere that bends so far on average [m]

// Places on another map.
constexpr double kBeenThere = 5;       // the robot was at a place that it has passed this near [m]
constexpr double kLeastSpread = 0.03;  // of the consensus where it is best [m]
constexpr double kLargeError = 0.2;    // from which on a place is worth a look [m]

// The shape of what is carried.
constexpr std::size_t kNeighbours = 8;

// Zones of a mask.
constexpr double kBlock = 0.5;  // side of the squares whose corners are carried [m]

// Constraints for other programs.
constexpr double kSameSpot = 1;  // farther apart, key frames are at two places [m]

}  // namespace roomgraph::fitted
