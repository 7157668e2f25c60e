#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   Comparison
// Out:  what is wrong with it
// Next: the end of a nightly job

// What walls may differ by, which is more than they do where furniture moves.
constexpr double kMostMissing = 0.15;  ///< of `walls_missing`, gone or thinned
constexpr double kMostThinned = 2.5;   ///< of `wall_sharpness`, over or below the others' median

/** What must not be. */
struct GateOptions {
  /** Each run must have a score that can be trusted, and at least this one. */
  std::optional<double> minScore;
  /** Each run must have a map error that can be trusted, and at most this one [m]; of one that is
   *  Certainty::doubtful the upper end of its interval counts. */
  std::optional<double> maxError;
  /** The same: at most so much more than the record, see recordError [m]. */
  std::optional<double> maxWorse;
  bool failsOnCoverage = false;     ///< a run has seen less than kNearlyAll
  bool failsOnBreaks = false;       ///< a run has a break that is not slight
  bool failsOnUnconfirmed = false;  ///< too much of a run is borne out by no other, see isBorneOut
  bool failsOnOtherSites = false;   ///< a run is of another site
  /** More than kMostMissing of the walls that others have are gone from a run, more than kMostAdded
   *  of its own in one place are in no other, or they are so much thinner or thicker, see
   *  kMostThinned. */
  bool failsOnWalls = false;
  /** Names of the runs that are judged: the others are the record. Each must be there, have a map
   *  error that can be trusted, and be no copy of one of the record. Empty where all are judged. */
  std::vector<std::string> candidates;

  [[nodiscard]] bool asksNothing() const {
    return !minScore && !maxError && !maxWorse && !failsOnCoverage && !failsOnBreaks &&
           !failsOnUnconfirmed && !failsOnOtherSites && !failsOnWalls && candidates.empty();
  }
};

/** The complaints are "run: what is wrong". A figure that is asked for and cannot be told is one,
 *  too: scores and map errors that cannot be trusted, and what takes two other maps where there is
 *  but one; a reference needs none of them. Where no run is left to judge, or to judge it by, that
 *  is a complaint.
 *
 *      GateOptions gate;
 *      gate.maxError = 0.3, gate.failsOnBreaks = true, gate.candidates = {"tonight"};
 *      for (const std::string& line : gateVerdict(comparison, gate).complaints)
 *        std::puts(line.c_str());  // "tonight: its map error of 0.412 m is ..."
 */
[[nodiscard]] GateVerdict gateVerdict(const Comparison& comparison, const GateOptions& options);

/** What is wrong with walls of a `wall_sharpness` beside the median of the others: more than
 *  kMostThinned times thinner or thicker; empty for nothing. */
[[nodiscard]] std::string sharpnessFault(double own, double usual);

}  // namespace roomgraph
