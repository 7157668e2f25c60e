#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/breaks/rigid_pieces.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// Ours
// In:   FollowedWalls of a run that carries no scans
// Out:  PieceBreak
// Next: siteBreaks

/** The place where a map of two pieces breaks. */
struct PieceBreak {
  Point place;           ///< as the run draws it [m, frame of the run]
  double rotation = 0;   ///< by which the second piece is turned too far [rad]
  double shift = 0;      ///< by which it is moved too far, at `place` [m]
  bool isPlaced = true;  ///< whether one of the pieces was drawn at `place`
  double bend = 0;       ///< RMS distance of the patches from where their piece would have them [m]
  /** Patches of the first and the second piece, ascending; a patch can be in both. */
  std::array<std::vector<std::size_t>, 2> pieces;
};

struct FindPiecesOptions {
  /** Of patches that surely are of one piece. */
  RigidPiecesOptions seeds{4.5, 0.04, 0.2, 0.08};
  std::size_t maxSeeds = 5;  ///< the largest ones, each two of which are tried
  /** What patches may be away from where their piece has them; half of both, or one of them. */
  double maxAway = 2.4;           ///< [m]
  double maxTurn = 0.2;           ///< [rad]
  double minExplained = 0.8;      ///< share of the followed walls that lie in the two pieces
  double minPiece = 0.15;         ///< and in the smaller one
  double minRotation = 0.044;     ///< of a break [rad]; less could be a drift
  double minShift = kBreakShift;  ///< of one that hardly turns [m]
  double minContrast = 2.5;       ///< of the break, times what the pieces themselves bend
  double maxTurnBend = 0.045;     ///< of the pieces, RMS [rad]; what turns more drifts
  /** Of patches of two pieces that are near each other, the share that may hold together, for each
   *  time that the break is more than the pieces bend; and what their poses differ by then. */
  double maxHeld = 0.02;
  double heldTurn = 0.06;  ///< [rad]
  double heldPlace = 0.4;  ///< halfway between them [m]
  double atSeam = 8;       ///< how far from a break its pieces tell of it [m]
  double maxOutside = 5;   ///< of the centre of a turn, from what a piece has drawn [m]
};

/** Whether the patches of `of` lie in the map `in` as two pieces, each of which may bend a
 *  little. Each two of the parts that surely hold together are tried: all patches go to the
 *  nearer one of the two, and both are fitted anew, until nothing changes (k-means); those two
 *  count that explain most walls. The first piece is the one that drew the walls around the
 *  origin of the run, where robots start, and that has the origin on free ground. A break that
 *  turns is where the turn has its centre, the motion being fitted to what is near; where that is
 *  far from both pieces, one of them was found in the wrong place, and `isPlaced` is false. One
 *  that only shifts is put into the middle of the patches that both pieces have, which can be
 *  many metres off. None for a map that is whole, or bends all along. O(patches^2). */
std::optional<PieceBreak> findPieces(const WallMap& of, const WallMap& in,
                                     const FollowedWalls& followed,
                                     const FindPiecesOptions& options);

}  // namespace roomgraph
