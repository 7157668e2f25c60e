#include "roomgraph/repair/carry_places.h"

#include <algorithm>
#include <cmath>

#include "fitted_repair.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/check/find_refuted.h"
#include "roomgraph/compare/RunScore.h"
#include "roomgraph/relate/follow_walls.h"
#include "roomgraph/relate/place_runs.h"
#include "roomgraph/repair/BendField.h"

namespace roomgraph {
namespace {

/** Why places are unsure in a building that repeats itself. */
constexpr const char* kTwice = "one of the maps has the place twice";
constexpr const char* kAmbiguous = "the maps may also fit each other in another pose";

/** Whether a map has a free cell up to `reach` away from a place, or in the cells beside it. */
bool isFreeNear(const WallMap& map, Point place, double reach) {
  const int cells = int(std::ceil(reach / map.frame.resolution));
  for (int x = -cells; x <= cells; ++x)
    for (int y = -cells; y <= cells; ++y)
      if (stateAt(map, place + map.frame.resolution * Point{double(x), double(y)}) == State::free)
        return true;
  return false;
}

/** Both ways of the site in one. */
struct BothWays {
  BendField::Carried there, onward;
};

/** Whether most pairs of a run are sure of how it lies in the others. */
bool areMostSureOf(std::size_t run, const MapPairs& pairs) {
  return 2 * countSure(pairs, run) > pairs.othersOf(run).size();
}

/** All that was thought of as to how run `from` may lie in run `to`. */
std::vector<Transform2D> otherPoses(std::size_t from, std::size_t to, const MapPairs& pairs) {
  const Alignment& alignment = pairs(from, to).alignment;
  std::vector<Transform2D> poses = alignment.poses;
  if (alignment.runnerUp) poses.push_back(alignment.runnerUp->pose);
  if (from < to)  // they say where `to` lies in `from`
    for (Transform2D& pose : poses) pose = pose.inverse();
  return poses;
}

class Carrier {
 public:
  Carrier(const SolvedSite& solved, const RealPoses& real, std::size_t from, std::size_t to,
          const ForEach& forEach)
      : old_(solved.site.mapOf(from)), new_(solved.site.mapOf(to)) {
    const auto refuted = findRefuted(solved.site, solved.consensus, forEach);
    isRefuted_ = refuted[from] || refuted[to];
    const auto hasScans = [&](std::size_t run) { return !solved.site.runs[run]->scans.empty(); };
    isThroughSite_ = hasScans(from) && hasScans(to);
    isOnlySaid_ = solved.pairs(from, to).alignment.isOnlySaid;
    isPlaceSure_ =
        from == to || (areMostSureOf(from, solved.pairs) && areMostSureOf(to, solved.pairs));
    otherPoses_ = otherPoses(from, to, solved.pairs);
    if (isThroughSite_) {
      fields_.emplace_back(solved, real, from, BendField::Way::toSite);
      fields_.emplace_back(solved, real, to, BendField::Way::toRun);
    } else {
      fields_.emplace_back(solved, from, to);
    }
  }

  CarriedPlace carry(const Place& place) const {
    CarriedPlace carried;
    const auto ways = waysOf(place.pose);
    if (!ways) {
      carried.reason = "neither map has been near it";
      return carried;
    }
    carried.pose = ways->onward.pose;
    carried.error =
        std::hypot(fitted::kLeastSpread, std::hypot(ways->there.spread, ways->onward.spread));
    judge(place, *ways, carried);
    return carried;
  }

 private:
  std::optional<BothWays> waysOf(const Transform2D& place) const {
    const auto there = fields_.front()(place);
    if (!there || !isThroughSite_)
      return there ? std::make_optional(BothWays{*there, *there}) : std::nullopt;
    const auto onward = fields_.back()(there->pose);
    return onward ? std::make_optional(BothWays{*there, *onward}) : std::nullopt;
  }

  void judge(const Place& place, const BothWays& ways, CarriedPlace& carried) const {
    const Point point = carried.pose->shift(), was = place.pose.shift();
    const auto flag = [&](CarryState state, const std::string& reason) {
      carried.state = state, carried.reason = reason;
    };
    carried.state = CarryState::carried;
    if (ways.onward.nearest > fitted::kBeenThere)
      return flag(
          CarryState::unseen,
          formatted("on the new map the robot came no nearer than %.1f m", ways.onward.nearest));
    const bool wasFree = !place.isCorner && stateAt(old_, was) == State::free;
    if (wasFree && stateAt(new_, point) == State::occupied &&
        !isFreeNear(new_, point, 3 * carried.error))
      return flag(CarryState::gone, "what was free is a wall now");
    if (wasFree && stateAt(new_, point) == State::occupied)
      return flag(CarryState::unsure, "it lies in a wall, with free space beside it");
    if (const std::string doubt = doubtOf(place, ways, carried); !doubt.empty())
      return flag(CarryState::unsure, doubt);
  }

  /** What speaks against it, in words; empty for nothing. Where what lies around it is found
   *  beside it, the error grows by that. */
  std::string doubtOf(const Place& place, const BothWays& ways, CarriedPlace& carried) const {
    if (std::max(ways.there.rival, ways.onward.rival) > BendField::kSameCopy) return kTwice;
    if (carried.error > fitted::kLargeError) return "the maps bend here";
    if (isOnlySaid_) return "the maps hardly show that they are of one site";
    if (isRefuted_) return "one of the maps lays places over each other that are not one";
    if (!place.isCorner && !isFreeNear(old_, place.pose.shift(), kSameWhereBent))
      return "the old map shows no free space there";
    const LocalScan view = viewFrom(old_, place.pose, kPatchReach);
    if (!view.isTelling()) return doubtUnseen(place, ways, carried);
    const Transform2D& pose = *carried.pose;
    const ScanFit here = fitNear(view, new_, pose);
    if (here.known < kMajority) return "the new map has hardly seen what lies around it";
    if (here.quality < kMajority) return "what lies around it looks otherwise on the new map";
    const double off = distance(here.pose.shift(), pose.shift());
    carried.error = std::hypot(carried.error, off);
    if (off > kSameWhereBent) return formatted("its surroundings are shifted by %.1f m", off);
    for (const ScanFit& other : findScan(view, new_, pose, kRoughly, 1))
      if (other.score * kRivalScore > here.score)
        return formatted("its surroundings fit better %.2f m away, turned by %.1f degrees",
                         distance(other.pose.shift(), pose.shift()),
                         std::abs(wrappedAngle(other.pose.phi - pose.phi)) * 180 / M_PI);
    return isPlaceSure_ || !looksAlikeElsewhere(place, view, here) ? "" : kAmbiguous;
  }

  /** Whether what lies around a place fits about as well where the maps may lie in each other
   *  otherwise, as in a building that repeats itself. */
  bool looksAlikeElsewhere(const Place& place, const LocalScan& view, const ScanFit& here) const {
    return otherPoses_.empty() || anyOf(otherPoses_, [&](const Transform2D& pose) {
             const ScanFit fit = fitNear(view, new_, pose * place.pose);
             return !areNear(fit.pose, here.pose, {}, kSameAnswer) &&
                    fit.score > kRivalScore * here.score;
           });
  }

  /** The same of a place of which the old map shows too little to know it by. */
  std::string doubtUnseen(const Place& place, const BothWays& ways,
                          const CarriedPlace& carried) const {
    if (!isPlaceSure_) return kAmbiguous;
    if (!ways.there.isKnown || !ways.onward.isKnown) return "only one of the maps has been here";
    const bool isNew =
        !ways.onward.isSeen || stateAt(new_, carried.pose->shift()) == State::unknown;
    const bool wasSeen = stateAt(old_, place.pose.shift()) != State::unknown;
    return wasSeen && isNew ? "the new map has hardly seen it" : "";
  }

  const WallMap &old_, &new_;
  bool isOnlySaid_ = false, isPlaceSure_ = false, isRefuted_ = false;
  std::vector<Transform2D> otherPoses_;  // new <- old
  bool isThroughSite_ = false;
  std::vector<BendField> fields_;
};

/** Whether nothing but free space lies between a place and a wall, but for what the wall itself and
 *  whatever the place lies in may take up. */
bool isInSight(const WallMap& map, Point from, Point wall) {
  const double length = distance(from, wall), step = map.frame.resolution / 2;
  const int steps = int(std::ceil((length - 2 * kSameWall) / step));
  for (int i = 0; i < steps; ++i) {
    const double along = kSameWall + i * step;
    if (stateAt(map, from + (along / length) * (wall - from)) != State::free) return false;
  }
  return true;
}

/** Where nearly all places are ambiguous, the rest only happens to look otherwise. */
void doubtAllIfNearlyAllAre(std::vector<CarriedPlace>& places) {
  const auto isCarried = [](const CarriedPlace& p) { return p.state == CarryState::carried; };
  const auto isAmbiguous = [](const CarriedPlace& p) {
    return p.reason == kTwice || p.reason == kAmbiguous;
  };
  const auto ambiguous = double(countIf(places, isAmbiguous));
  const auto carried = double(countIf(places, isCarried));
  if (ambiguous < kNearlyAll * (ambiguous + carried)) return;
  for (CarriedPlace& place : places)
    if (isCarried(place)) place.state = CarryState::unsure, place.reason = kAmbiguous;
}

}  // namespace

std::vector<CarriedPlace> carryPlaces(const std::vector<Place>& places, const SolvedSite& solved,
                                      const RealPoses& real, std::size_t from, std::size_t to,
                                      const ForEach& forEach) {
  const Carrier carrier(solved, real, from, to, forEach);
  std::vector<CarriedPlace> carried(places.size());
  forEach(places.size(), [&](std::size_t i) { carried[i] = carrier.carry(places[i]); });
  doubtAllIfNearlyAllAre(carried);
  return carried;
}

LocalScan viewFrom(const WallMap& map, const Transform2D& pose, double range) {
  LocalScan view;
  const Point eye = pose.shift();
  const Motion2D back(pose.inverse());
  for (const WallPoint& wall : map.walls)
    if (squaredNorm(wall.place - eye) < range * range && dot(wall.normal, eye - wall.place) > 0 &&
        isInSight(map, eye, wall.place))
      view.walls.push_back({back(wall.place), back.turned(wall.normal)});
  return view;
}

}  // namespace roomgraph
