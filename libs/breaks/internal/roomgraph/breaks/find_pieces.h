#pragma once
#include <optional>

#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// Ours
// In:   FollowedWalls of a run that carries no scans
// Out:  PieceBreak
// Next: compareRuns

/** The place where a map of two rigid pieces breaks. */
struct PieceBreak {
  Point place;          ///< [m, frame of the run]
  double rotation = 0;  ///< by which the second piece is turned too far [rad]
  double shift = 0;     ///< by which it is moved too far, at `place` [m]
  Transform2D pose;     ///< in <- run, of the first piece
};

struct FindPiecesOptions {
  double sameTurn = 0.02;         ///< of patches in one piece [rad]
  double samePlace = 0.15;        ///< the same, at the patch [m]
  double minExplained = 0.7;      ///< share of the followed walls that lie in the two pieces
  double minPiece = 0.15;         ///< and in the smaller one
  double minRotation = 0.044;     ///< of a break [rad]; less could be a drift
  double minShift = kBreakShift;  ///< of one that hardly turns [m]
};

/** Whether nearly all patches have one of two poses, and how these differ. The first piece is the
 *  one whose walls are nearest to the origin of the run, where robots start. A break that turns is
 *  where the turn has its centre; one that only shifts is put into the middle of the patches that
 *  both pieces have, which can be metres off. None for a map that is whole, that bends all along or
 *  that has more pieces. O(patches^2). */
std::optional<PieceBreak> findPieces(const MapForAlignment& of, const FollowedWalls& followed,
                                     const FindPiecesOptions& options);

}  // namespace roomgraph
