#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/align/near_poses.h"
#include "roomgraph/breaks/ScanBreak.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// In:   FollowedWalls of a run that carries no scans
// Out:  PieceBreak
// Next: siteBreaks

/** How the two pieces of a map that is torn lie beside each other. */
struct PieceBreak {
  Point place;          ///< as the run draws it [m, frame of the run]
  double rotation = 0;  ///< by which the smaller piece is turned too far [rad]
  double shift = 0;     ///< by which it is moved too far, where it hardly turns [m]
  double bend = 0;      ///< RMS distance of the patches from where their piece would have them [m]
  std::array<std::vector<std::size_t>, 2> pieces;  ///< their patches, the larger piece first
};

/** By how much the break must be more than what the pieces themselves bend, as
 *  benchmarks/break_accuracy judges it. */
constexpr double kPieceContrast = 2.5;
/** Share of the walls that were found, of the smaller piece. */
constexpr double kSmallestPiece = 0.15;

/** Whether the patches of a run lie in another map as two pieces, each of which may bend a
 *  little. Each two of the rigid pieces are tried: all patches go to the nearer one of the two,
 *  and both are fitted anew, until nothing changes (k-means); those two count that explain most
 *  walls. A break that turns is where the turn has its centre. Walls do not tell where one is
 *  that only shifts: it is put to where the pieces come nearest. An end that is torn off
 *  (kTornLayer) is the smaller one where there are no such two. None for a map that is whole, or
 *  bends all along. O(pieces^2 * patches + patches^2). */
std::optional<PieceBreak> findPieces(const WallPatches& patches, const FollowedWalls& followed,
                                     const FindBreaksOptions& options);

/** Patches that hold together, as indices of `followed.patches`, ascending: those that are near by
 *  and whose poses in the other map are kSameScanAnswer, and so on from one to the next.
 *  So a map that bends bit by bit is one piece, and one that jumps is two. Most walls first;
 *  without those that are too small to count; none where nothing was followed.
 *  O(patches * patches within reach). */
std::vector<std::vector<std::size_t>> rigidPieces(const WallPatches& patches,
                                                  const FollowedWalls& followed);

}  // namespace roomgraph
