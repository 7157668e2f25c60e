#pragma once
#include <cstddef>

namespace roomgraph {

/** Error at which the score is 100 / e [m]. */
constexpr double kScoreScale = 0.5;
/** The least share of walls in common with another run, for a score that is meaningful. */
constexpr double kLeastShare = 0.2;

/** What the walls of one run say against those of the others. */
struct RunScore {
  double share = 0;  ///< of the walls that the others have, too, each weighted by its trust
  double mapError = 0, errorLow = 0, errorHigh = 0;  ///< estimate of the true map error [m]
  double score = 100, low = 100, high = 100;         ///< 0 to 100, falls with the map error
  double trust = 0;           ///< weight of this run in the consensus, the largest of all runs is 1
  double support = 0;         ///< wall points that were compared
  std::size_t others = 0;     ///< runs it was compared with
  bool isMeaningful = false;  ///< see scoreRuns
};

}  // namespace roomgraph
