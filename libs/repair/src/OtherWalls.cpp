#include "OtherWalls.h"

#include "fitted_repair.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
OtherWalls::OtherWalls(const SolvedSite& solved, std::size_t but,
                       const std::vector<Point>& places) {
  std::vector<LocalScan> scans;
  std::vector<Transform2D> poses;
  for (std::size_t i = 0; i < solved.site.runs.size(); ++i) {
    if (i == but || solved.maps.firstOf(i) == solved.maps.firstOf(but)) continue;
    const std::vector<LocalScan> local = localScans(solved.site.runs[i]->scans);
    const std::vector<Transform2D> real = solved.consensus.posesOf(i);
    for (std::size_t k = 0; k < local.size(); ++k) {
      if (!anyOf(places,
                 [&](Point place) { return distance(place, real[k].shift()) < fitted::kEarshot; }))
        continue;
      scans.push_back(local[k]);
      poses.push_back(real[k]);
    }
  }
  if (!scans.empty()) map_ = scanMap(scans, poses, numbersFrom(0, scans.size()));
}

}  // namespace roomgraph
