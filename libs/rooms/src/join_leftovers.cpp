#include "join_leftovers.h"

#include <algorithm>
#include <utility>

#include "roomgraph/rooms/Regions.h"

namespace roomgraph {
namespace {

using Neighbours = RegionGroups::Neighbours;
constexpr std::uint32_t kNone = Regions::kNone;
/** Sums of areas that differ by less than this share are equal. */
constexpr double kSameArea = 1e-6;
/** A deeper niche is a way [squares round its largest disc]. */
constexpr double kDeepestAlcove = 2.5;

bool isLeftover(const RegionGroups& regions, const SplitAtDoorsOptions& options,
                std::uint32_t region) {
  // A door frame is wider than it is deep; the disc in a room leaves at most its corners over.
  return regions.elongation(region) < options.minElongation ||
         regions.area(region) < options.maxLeftoverArea;
}

/** Whether a narrow region opens widely into one other and nowhere else, and is short or comes back
 *  to it: the space between a bed and the wall, a niche, the way round a table. */
bool isAlcove(const RegionGroups& regions, const SplitAtDoorsOptions& options, std::uint32_t region,
              const Neighbours& around) {
  if (around.size() != 1) return false;
  const auto& [other, passage] = *around.begin();
  return 2 * regions.radius(region) < options.openRoomWidth * (1 - kSameWidth) &&
         regions.radius(region) < regions.radius(other) * (1 - kSameWidth) &&
         passage.clearance >= options.maxRatio * regions.radius(region) * (1 - kSameWidth) &&
         (passage.count > 1 || regions.elongation(region) <= kDeepestAlcove);
}

/** The neighbour behind the widest passage; of several as wide the largest. None where these are
 *  equal, too, for then only the map's pose could decide. */
std::uint32_t hostOf(const RegionGroups& regions, const Neighbours& around) {
  double widest = 0;
  for (const auto& [other, passage] : around) widest = std::max(widest, passage.clearance);
  std::uint32_t host = kNone;
  bool isTie = false;
  for (const auto& [other, passage] : around) {
    if (passage.clearance < widest * (1 - kSameWidth)) continue;
    const double area = regions.area(other), best = host == kNone ? 0 : regions.area(host);
    if (area > best * (1 + kSameArea)) {
      host = other;
      isTie = false;
    } else if (area > best * (1 - kSameArea)) {
      isTie = true;
    }
  }
  return isTie ? kNone : host;
}

}  // namespace

void joinLeftovers(RegionGroups& regions, const SplitAtDoorsOptions& options) {
  for (bool isAny = true; isAny;) {
    // All at once: so no order matters, and no two that are no leftovers are ever joined.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> hosts;
    for (const auto& [region, around] : regions.neighbours()) {
      if (!isLeftover(regions, options, region) && !isAlcove(regions, options, region, around))
        continue;
      const std::uint32_t host = hostOf(regions, around);
      if (host != kNone) hosts.push_back({region, host});
    }
    for (const auto& [region, host] : hosts) regions.join(region, host);
    isAny = !hosts.empty();
  }
}

}  // namespace roomgraph
