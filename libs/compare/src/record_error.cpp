#include "roomgraph/compare/record_error.h"

#include <algorithm>

#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

constexpr std::size_t kBest = 3;  // runs that a new one is held against

}  // namespace

std::optional<double> trustedError(const ComparedRun& run) {
  if (!run.score || !run.score->isMeaningful) return {};
  return run.score->mapError;
}

std::optional<RecordError> recordError(const Comparison& comparison, const std::string& run,
                                       const std::vector<std::string>& candidates) {
  std::vector<double> errors;
  for (const ComparedRun& other : comparison.runs) {
    if (other.name == run || other.name == comparison.reference) continue;
    if (contains(candidates, other.name)) continue;
    if (const auto error = trustedError(other)) errors.push_back(*error);
  }
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  errors.resize(std::min(kBest, errors.size()));
  return RecordError{median(errors), errors.size()};
}

}  // namespace roomgraph
