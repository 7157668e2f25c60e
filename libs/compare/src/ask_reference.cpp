#include "ask_reference.h"

#include "roomgraph/check/check_run.h"

namespace roomgraph {

ReferenceFaults askReference(const Site& site, RunScores& scores) {
  if (!site.reference || site.runs[*site.reference]->scans.empty()) return {};
  const Transform2D& pose = site.poses[*site.reference];
  const RunCheck check = checkRun(*site.runs[*site.reference]);
  ReferenceFaults faults;
  if (!check.doubled.empty()) faults.doubled = check.doubled.front().apart;
  for (MapBreak found : check.breaks) {
    if (!found.torn) continue;
    found.place = pose(found.place);
    found.torn = TornPose{pose * found.torn->drawn, pose * found.torn->untorn};
    faults.breaks.push_back(found);
  }
  for (auto& score : scores)
    if (score && (faults.doubled > 0 || !faults.breaks.empty())) score->isMeaningful = false;
  return faults;
}

}  // namespace roomgraph
