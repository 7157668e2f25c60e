#include "roomgraph/compare/compare_maps.h"

#include <algorithm>

namespace roomgraph {

Comparison compareMaps(const ReadRuns& read, const CompareMapsOptions& options) {
  CompareRunsOptions compare = options.compare;
  compare.reference = read.reference;
  Comparison result = compareRuns(
      read.runs, relateRuns(read.runs, compare.areAligned, compare.forEach, compare.kept), compare);
  result.leftOut.insert(result.leftOut.end(), read.leftOut.begin(), read.leftOut.end());
  std::sort(result.leftOut.begin(), result.leftOut.end(),
            [](const LeftOutRun& l, const LeftOutRun& r) { return l.name < r.name; });
  return result;
}

Comparison compareMaps(const std::vector<std::string>& files, const CompareMapsOptions& options) {
  return compareMaps(readRuns(files, options), options);
}

}  // namespace roomgraph
