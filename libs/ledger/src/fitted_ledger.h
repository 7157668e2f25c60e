#pragma once
#include <cstddef>

/** What the rooms of a site were set by: the maps drawn in tests/ledger show each rule by itself,
 *  and `benchmarks/night_histories` what becomes of rooms and doors over sixty nights. */
namespace roomgraph::fitted {

// Areas of all runs in one frame.
constexpr double kMargin = 0.5;  // of the frame round all areas [m]
constexpr double kLeastWeight = 0.1;

// A room in a run.
constexpr double kFirstTurn = 0.07;  // of the refinement [rad]
constexpr int kHalvings = 4;
constexpr double kMoveCost = 0.03;     // per metre from the start
constexpr double kLeastOverlap = 0.1;  // below which a fit is none
constexpr std::size_t kMostAreas = 3;  // that a room may be

// Which area is which room.
constexpr double kFewDoors = 3;          // that tell a room apart, whatever its overlap
constexpr double kNeighbourBonus = 0.2;  // added to the overlap where all neighbours match, too
constexpr double kOtherKindCost = 0.05;  // taken off where one is a room and the other a corridor
constexpr double kSurpriseCost = 0.1;    // and per metre from where the neighbours say
constexpr int kMatchRounds = 3;          // the first looks at overlap alone
constexpr double kMinInside = 0.6;       // share of one in the other from which on it is a part
constexpr double kMinContainer = 0.75;   // size of an area, in that of the rooms it is to hold

// What is a room.
constexpr double kMaxCovered = 0.3;    // share of a candidate that rooms may cover already
constexpr double kMinCandidate = 1.0;  // of a candidate [m2]
constexpr double kNarrow = 0.7;        // mean width of a gap [m]
constexpr double kLeastPower = 0.06;   // of the runs of a left area, in that of the second best

// What is a door.
constexpr double kSameDoor = 0.8;  // one that leads to the same room may lie off as rooms do [m]

// What each run has of a room.
constexpr double kComplete = 0.8;       // known share from which on its size can be compared
constexpr double kMinAgreement = 0.45;  // of outlines, below which no shift can be told

}  // namespace roomgraph::fitted
