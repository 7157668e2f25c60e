#pragma once
#include "roomgraph/base/Json.h"
#include "roomgraph/compare/RunScore.h"

namespace roomgraph {

/** The figures as comparison.json holds them: what is printed of a comparison and of its file is
 *  the same, though it has fewer digits. */
inline RunScore asWritten(RunScore score) {
  for (double* figure :
       {&score.score, &score.low, &score.high, &score.mapError, &score.errorLow, &score.errorHigh})
    *figure = rounded(*figure);
  return score;
}

}  // namespace roomgraph
