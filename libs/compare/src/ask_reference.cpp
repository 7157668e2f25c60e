#include "ask_reference.h"

#include "roomgraph/check/check_run.h"

namespace roomgraph {

std::vector<MapBreak> askReference(const Site& site, RunScores& scores) {
  if (!site.reference || site.runs[*site.reference]->scans.empty()) return {};
  const Transform2D& pose = site.poses[*site.reference];
  std::vector<MapBreak> breaks;
  for (MapBreak found : checkRun(*site.runs[*site.reference]).breaks) {
    if (!found.torn) continue;
    found.place = pose(found.place);
    found.torn = TornPose{pose * found.torn->drawn, pose * found.torn->untorn};
    breaks.push_back(found);
  }
  for (auto& score : scores)
    if (score && !breaks.empty()) score->isMeaningful = false;
  return breaks;
}

}  // namespace roomgraph
