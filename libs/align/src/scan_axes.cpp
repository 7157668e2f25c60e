#include "roomgraph/align/scan_axes.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/principal_axis.h"

namespace roomgraph {
namespace {

constexpr double kPiece = 1.0;             // of wall; there is no gap of half of it in one [m]
constexpr std::size_t kMinBeams = 4;       // beams along a piece
constexpr double kPieceRoughness = 0.03;   // standard deviation across a piece [m]
constexpr double kFullLength = 5;          // from which on more tells no more [m]
constexpr double kMinAxesAgreement = 0.6;  // of the directions, 1 where all are the same

/** The last end of the piece of wall that starts at `first`, and its length. */
struct Piece {
  std::size_t last = 0;
  double length = 0;
};

Piece pieceFrom(const std::vector<Point>& ends, std::size_t first) {
  Piece piece{first, 0};
  while (piece.last + 1 < ends.size() && piece.length < kPiece) {
    const double gap = distance(ends[piece.last], ends[piece.last + 1]);
    if (gap > kPiece / 2) break;
    piece.length += gap, ++piece.last;
  }
  return piece;
}

}  // namespace

std::optional<ScanAxes> scanAxes(const std::vector<Point>& ends) {
  double cosine = 0, sine = 0, length = 0;
  for (std::size_t first = 0; first + 2 < ends.size();) {
    const Piece piece = pieceFrom(ends, first);
    if (piece.length < kPiece || piece.last - first < kMinBeams) {
      first = std::max(first + 1, piece.last);
      continue;
    }
    PointSums sums;
    for (std::size_t i = first; i <= piece.last; ++i) sums.add(ends[i]);
    if (const PrincipalAxis axis = principalAxis(sums);
        axis.across < kPieceRoughness * kPieceRoughness) {
      cosine += piece.length * std::cos(4 * axis.direction);  // all four directions as one
      sine += piece.length * std::sin(4 * axis.direction);
      length += piece.length;
    }
    first = piece.last;
  }
  if (length == 0) return std::nullopt;
  // Where all agree, rounding makes it a hair more than all.
  const double agreement = std::min(1.0, std::hypot(cosine, sine) / length);
  if (agreement <= kMinAxesAgreement) return std::nullopt;
  return ScanAxes{std::atan2(sine, cosine) / 4, agreement * std::min(1.0, length / kFullLength)};
}

}  // namespace roomgraph
