#include "roomgraph/relate/Run.h"

#include <algorithm>
#include <tuple>

namespace roomgraph {

void sortRuns(std::vector<Run>& runs) {
  std::sort(runs.begin(), runs.end(), [](const Run& l, const Run& r) {
    return std::tie(l.sha256, l.name, l.file) < std::tie(r.sha256, r.name, r.file);
  });
}

}  // namespace roomgraph
