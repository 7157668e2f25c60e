#pragma once
#include <optional>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// Ours
// In:   the mean wall distance of each pair of runs
// Out:  RunScore of each run
// Next: compareRuns

/** Mean wall distance of two runs, both ways together. */
struct PairDistance {
  double mean = 0;   ///< [m]
  double count = 0;  ///< wall points; 0 where nothing could be compared
};

/** How a distance becomes an error, and an error a score. The constants of the error are fitted to
 *  simulated runs whose true error is known: see docs/scoring.md. */
struct RunScoreOptions {
  double trustFloor = 0.05;   ///< disagreement below which all runs are trusted alike [m]
  int iterations = 100;       ///< at most
  double fullCount = 500;     ///< a pair with fewer wall points counts less
  double noise = 0.08;        ///< wall distance of two maps without error, from cells and beams [m]
  double scale = 3.4;         ///< error at a distance of 1 m beyond the noise [m]
  double power = 1.0;         ///< of the distance beyond the noise
  double spread = 2.0;        ///< factor either way that holds 80 % of the errors of the fit
  double smallError = 0.03;   ///< added to errors before that factor [m]
  double scoreScale = 0.5;    ///< error at which the score is 100 / e [m]
  double minCount = 300;      ///< wall points from which on a score is meaningful
  std::size_t minOthers = 2;  ///< runs from which on a score is meaningful; 1 with a reference
};

/** Estimated map error at a consensus distance [m]: scale * (distance - noise)^power, from 0 on. */
double mapErrorAt(double distance, const RunScoreOptions& options);

/** Scores each run against the consensus of the others. Its consensus distance is the mean of its
 *  distances to the others, weighted by their trust, which is 1 / (trustFloor + their own consensus
 *  distance)^4; both are repeated until nothing moves, from the median of each run's distances on,
 *  so one run that is unlike all others has next to no weight. With `reference`, only the distance
 *  to that run counts, and it gets no score itself. The interval: 1.28 jackknife standard errors
 *  over the other runs, and the spread of the fit. Runs that share walls with no other have no
 *  score. Meaningful with minOthers other runs (one reference) and minCount wall points.
 *  `distances` is square and symmetric; its diagonal is not read. O(iterations * runs^2).
 *  @throws UsageError where `reference` is none of the runs. */
std::vector<std::optional<RunScore>> scoreRuns(
    const std::vector<std::vector<PairDistance>>& distances, std::optional<std::size_t> reference,
    const RunScoreOptions& options);

}  // namespace roomgraph
