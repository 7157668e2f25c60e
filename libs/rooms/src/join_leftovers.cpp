#include "join_leftovers.h"

#include <utility>

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

using Neighbours = RegionGroups::Neighbours;
/** Sums of areas that differ by less than this share are equal. */
constexpr double kSameArea = 1e-6;

bool isLeftover(const RegionGroups& regions, std::uint32_t region, const Neighbours& around) {
  if (regions.area(region) < regions.options().maxLeftoverArea * (1 - kSameArea)) return true;
  // A door frame is wider than it is deep; the disc in a room leaves at most its corners over. That
  // in a cubicle may reach out of its front.
  const auto isOwnFront = [](const auto& way) { return way.second.isOwnFront; };
  return regions.elongation(region) < regions.options().minElongation && !anyOf(around, isOwnFront);
}

/** The one wider neighbour that a region opens into with nearly its whole width; none where there
 *  are several, or where it is long. What comes back to it is short. */
std::uint32_t openTo(const RegionGroups& regions, std::uint32_t region, const Neighbours& around) {
  const double width = regions.options().maxRatio * regions.radius(region) * (1 - kSameWidth);
  std::uint32_t found = Regions::kNone;
  for (const auto& [other, passage] : around) {
    if (passage.clearance < width) continue;
    const bool isShort = passage.count > 1 || regions.elongation(region) <= kDeepestAlcove;
    const bool isWider = regions.radius(region) < regions.radius(other) * (1 - kSameWidth);
    if (found != Regions::kNone || !isShort || !isWider) return Regions::kNone;
    found = other;
  }
  return found;
}

/** A narrow region that opens into one other and nowhere else, and does not lie off a corridor:
 *  the space between a bed and the wall, a niche, the way round a table. */
bool isAlcove(const RegionGroups& regions, std::uint32_t region, const Neighbours& around) {
  return around.size() == 1 && !around[0].second.isOffCorridor && regions.isNarrow(region) &&
         openTo(regions, region, around) != Regions::kNone;
}

/** A wider one that opens into a room; all other ways out of it are doors. What opens into a
 *  corridor is a room, and a fan of beams stays apart. */
bool isBay(const RegionGroups& regions, std::uint32_t region, const Neighbours& around) {
  if (regions.isNarrow(region) || regions.wallShare(region) < regions.options().minWallShare)
    return false;
  const auto isFront = [](const auto& way) { return way.second.isFront; };
  if (anyOf(around, isFront)) return false;
  const std::uint32_t room = openTo(regions, region, around);
  return room != Regions::kNone && !regions.isLong(room);
}

/** The neighbour behind the widest passage, which is a front only where all are; of several as wide
 *  the largest. None where these are equal, too, for then only the map's pose could decide. */
std::uint32_t hostOf(const RegionGroups& regions, const Neighbours& around) {
  const auto isWiderThan = [](const RegionGroups::Passage& p, const RegionGroups::Passage& q) {
    return p.isFront != q.isFront ? q.isFront : p.clearance * (1 - kSameWidth) > q.clearance;
  };
  RegionGroups::Passage widest = around.front().second;
  for (const auto& [other, passage] : around)
    if (isWiderThan(passage, widest)) widest = passage;
  std::uint32_t host = Regions::kNone;
  bool isTie = false;
  for (const auto& [other, passage] : around) {
    if (isWiderThan(widest, passage)) continue;
    const double area = regions.area(other), best = host == Regions::kNone ? 0 : regions.area(host);
    if (area > best * (1 + kSameArea)) {
      host = other;
      isTie = false;
    } else if (area > best * (1 - kSameArea)) {
      isTie = true;
    }
  }
  return isTie ? Regions::kNone : host;
}

/** All at once: so no order matters, and no two that are none of these are ever joined. Returns
 *  whether there was any. */
template <class IsOne>
bool joinAll(RegionGroups& regions, const IsOne& isOne) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> hosts;
  for (const auto& [region, around] : regions.neighbours()) {
    if (!isOne(region, around)) continue;
    const std::uint32_t host = hostOf(regions, around);
    if (host != Regions::kNone) hosts.push_back({region, host});
  }
  for (const auto& [region, host] : hosts) regions.join(region, host);
  return !hosts.empty();
}

}  // namespace

void joinLeftovers(RegionGroups& regions) {
  const auto isSmall = [&](std::uint32_t region, const Neighbours& around) {
    return isLeftover(regions, region, around) || isAlcove(regions, region, around);
  };
  const auto isBayOf = [&](std::uint32_t region, const Neighbours& around) {
    return isBay(regions, region, around);
  };
  do  // a region has its whole shape only when its corners have joined it
    while (joinAll(regions, isSmall)) {
    }
  while (joinAll(regions, isBayOf));
}

void eachDoorFrame(RegionGroups& regions, const std::vector<RegionKind>& kinds, RegionKind between,
                   const std::function<void(std::uint32_t, const Neighbours&)>& visit) {
  const auto isOfKind = [&](const auto& way) { return kinds[way.first] == between; };
  for (const auto& [region, around] : regions.neighbours())
    if (around.size() == 2 && allOf(around, isOfKind) && isLeftover(regions, region, around))
      visit(region, around);
}

void joinDoorFrames(RegionGroups& regions, std::vector<RegionKind>& kinds) {
  eachDoorFrame(regions, kinds, RegionKind::room,
                [&](std::uint32_t region, const Neighbours& both) {
                  kinds[region] = RegionKind::room;
                  regions.join(region, regions.larger(both[0].first, both[1].first));
                });
}

}  // namespace roomgraph
