#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// Ours
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

/** The complaints are "run: what is wrong". Coverage counts as it is, meaningful or not, scores and
 *  map errors only where they can be trusted; a reference needs none of them. Where no run is left
 *  to judge, or to judge it by, that is a complaint.
 *
 *      GateOptions gate;
 *      gate.maxError = 0.3, gate.failsOnBreaks = true, gate.candidates = {"tonight"};
 *      for (const std::string& line : gateVerdict(comparison, gate).complaints)
 *        std::puts(line.c_str());  // "tonight: its map error of 0.412 m is ..."
 */
[[nodiscard]] GateVerdict gateVerdict(const Comparison& comparison, const GateOptions& options);

/** The record that a run is held against. */
struct RecordError {
  double error = 0;      ///< the median of the least map errors of others [m]
  std::size_t runs = 0;  ///< how many others that median is of, at most three
};

/** The record of a run: the three least map errors that can be trusted, of runs that are neither
 *  this one nor among the candidates; nothing where there is none. */
[[nodiscard]] std::optional<RecordError> recordError(const Comparison& comparison,
                                                     const std::string& run,
                                                     const std::vector<std::string>& candidates);

/** What is wrong with walls of a `wall_sharpness` beside the median of the others: more than
 *  kMostThinned times thinner or thicker; empty for nothing. */
[[nodiscard]] std::string sharpnessFault(double own, double usual);

}  // namespace roomgraph
