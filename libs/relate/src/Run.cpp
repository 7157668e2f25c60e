#include "roomgraph/relate/Run.h"

#include <algorithm>
#include <tuple>

namespace roomgraph {

bool isBefore(const Run& l, const Run& r) {
  return std::tie(l.sha256, l.name, l.file) < std::tie(r.sha256, r.name, r.file);
}

void sortRuns(std::vector<Run>& runs) { std::sort(runs.begin(), runs.end(), isBefore); }

}  // namespace roomgraph
