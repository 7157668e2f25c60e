#include "roomgraph/relate/Run.h"

#include <algorithm>
#include <tuple>

namespace roomgraph {

const Run* findRun(const std::vector<Run>& runs, const std::string& name) {
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const Run& run) { return run.name == name; });
  return found == runs.end() ? nullptr : &*found;
}

bool isBefore(const Run& l, const Run& r) {
  return std::tie(l.sha256, l.name, l.file) < std::tie(r.sha256, r.name, r.file);
}

void sortRuns(std::vector<Run>& runs) { std::sort(runs.begin(), runs.end(), isBefore); }

}  // namespace roomgraph
