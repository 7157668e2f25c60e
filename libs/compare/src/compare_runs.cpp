#include "roomgraph/compare/compare_runs.h"

#include <string>

#include "roomgraph/compare/compare_related.h"

namespace roomgraph {
namespace {

std::size_t placeOf(const std::string& name, const std::vector<Run>& runs) {
  std::size_t place = 0;
  while (runs[place].name != name) ++place;
  return place;
}

}  // namespace

Comparison compareRuns(std::vector<Run> runs, const CompareRunsOptions& options) {
  CompareRunsOptions sorted = options;
  const bool hasReference = options.reference && *options.reference < runs.size();
  const std::string reference = hasReference ? runs[*options.reference].name : "";
  sortRuns(runs);
  if (hasReference) sorted.reference = placeOf(reference, runs);
  return compareRelated(
      runs, relateRuns(runs, relateOptionsOf(sorted), options.forEach, options.kept), sorted);
}

}  // namespace roomgraph
