#include "roomgraph/relate/PreparedRun.h"

#include <algorithm>
#include <tuple>

namespace roomgraph {

void sortRuns(std::vector<PreparedRun>& runs) {
  std::sort(runs.begin(), runs.end(), [](const PreparedRun& l, const PreparedRun& r) {
    return std::tie(l.sha256, l.name, l.file) < std::tie(r.sha256, r.name, r.file);
  });
}

}  // namespace roomgraph
