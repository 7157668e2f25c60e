#include "roomgraph/breaks/place_break.h"

#include "roomgraph/align/step_hold.h"
#include "roomgraph/base/majority.h"

namespace roomgraph {
namespace {

constexpr std::size_t kFar = 5;

}  // namespace

std::size_t placeBreak(const std::vector<ScanWalls>& scans, const std::vector<bool>& isSeen,
                       std::size_t found) {
  std::size_t first = found, last = found;
  while (first > 1 && found - first < kFar && !isSeen[first - 1]) --first;
  while (last + 1 < scans.size() && last - found < kFar && !isSeen[last]) ++last;
  std::size_t place = found;
  double least = kMajority * commonWalls(scans[found - 1], scans[found]);
  for (std::size_t k = first; k <= last; ++k)
    if (const double share = commonWalls(scans[k - 1], scans[k]); share < least)
      least = share, place = k;
  return place;
}

}  // namespace roomgraph
