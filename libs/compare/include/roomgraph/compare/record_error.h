#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   Comparison
// Out:  RecordError
// Next: gateVerdict

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

/** The map error of a run, if it can be trusted [m]. */
[[nodiscard]] std::optional<double> trustedError(const ComparedRun& run);

}  // namespace roomgraph
