#include "roomgraph/repair/carry_places.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/repair/BendField.h"

namespace roomgraph {
namespace {

constexpr double kBeenThere = 5;        // the robot was at a place that it has passed this near [m]
constexpr double kNearlyThere = 3;      // and looks at what is this near from close by [m]
constexpr double kLeastCarried = 0.03;  // of the consensus where it is best [m]
constexpr double kLargeError = 0.2;     // from which on a place is worth a look [m]
constexpr double kMostDoubt = 0.05;     // share of the weight that has it elsewhere, for the same

State stateAt(const WallMap& map, Point place) {
  const std::size_t cell = cellIndexAt(map.frame, place);
  return cell < map.states.size() ? map.states[cell] : State::unknown;
}

/** Whether a map has a free cell up to `reach` away from a place. */
bool isFreeNear(const WallMap& map, Point place, double reach) {
  const int cells = int(reach / map.frame.resolution);
  for (int x = -cells; x <= cells; ++x)
    for (int y = -cells; y <= cells; ++y)
      if (stateAt(map, place + map.frame.resolution * Point{double(x), double(y)}) == State::free)
        return true;
  return false;
}

/** Both ways of the site in one. */
struct Route {
  BendField::Carried there, onward;
};

class Carrier {
 public:
  Carrier(const SolvedSite& solved, const RealPoses& real, std::size_t from, std::size_t to)
      : old_(solved.site.mapOf(from)), new_(solved.site.mapOf(to)) {
    const auto hasScans = [&](std::size_t run) { return !solved.site.runs[run]->scans.empty(); };
    isThroughSite_ = hasScans(from) && hasScans(to);
    isPlaceSure_ = isSure(solved, from) && isSure(solved, to);
    if (isThroughSite_) {
      fields_.emplace_back(solved, real, from, BendField::Way::toSite);
      fields_.emplace_back(solved, real, to, BendField::Way::toRun);
    } else {
      fields_.emplace_back(solved, from, to);
    }
  }

  CarriedPlace carry(const Place& place) const {
    CarriedPlace carried;
    const auto route = routeOf(place.pose);
    if (!route) {
      carried.reason = "neither map has been near it";
      return carried;
    }
    carried.pose = route->onward.pose;
    carried.error =
        std::hypot(kLeastCarried, std::hypot(route->there.spread, route->onward.spread));
    judge(place, *route, carried);
    return carried;
  }

 private:
  std::optional<Route> routeOf(const Transform2D& place) const {
    const auto there = fields_.front()(place);
    if (!there || !isThroughSite_)
      return there ? std::make_optional(Route{*there, *there}) : std::nullopt;
    const auto onward = fields_.back()(there->pose);
    return onward ? std::make_optional(Route{*there, *onward}) : std::nullopt;
  }

  void judge(const Place& place, const Route& route, CarriedPlace& carried) const {
    const Point at = carried.pose->shift(), was = place.pose.shift();
    const auto flag = [&](CarryState state, const std::string& reason) {
      carried.state = state, carried.reason = reason;
    };
    carried.state = CarryState::carried;
    if (route.onward.nearest > kBeenThere)
      return flag(CarryState::unseen,
                  formatted("the new map was made no nearer than %.1f m", route.onward.nearest));
    const bool wasFree = stateAt(old_, was) == State::free;
    if (wasFree && stateAt(new_, at) == State::occupied && !isFreeNear(new_, at, 3 * carried.error))
      return flag(CarryState::gone, "what was free is a wall now");
    if (wasFree && stateAt(new_, at) == State::occupied)
      return flag(CarryState::unsure, "it lies in a wall, with free space beside it");
    if (!isPlaceSure_) return flag(CarryState::unsure, "the maps may lie in each other otherwise");
    if (std::max(route.there.doubt, route.onward.doubt) > kMostDoubt)
      return flag(CarryState::unsure, "one of the maps has the place twice");
    if (carried.error > kLargeError) return flag(CarryState::unsure, "the maps bend here");
    if (!route.there.isKnown || !route.onward.isKnown)
      return flag(CarryState::unsure, "one map alone has been here");
    if (route.onward.nearest > kNearlyThere &&
        (!route.onward.isSeen || stateAt(new_, at) == State::unknown))
      return flag(CarryState::unsure, "the new map has hardly seen it");
  }

  /** Whether most pairs of a run are sure of how it lies in the others. */
  static bool isSure(const SolvedSite& solved, std::size_t run) {
    const std::vector<std::size_t>& others = solved.pairs.othersOf(run);
    const auto sure = std::count_if(others.begin(), others.end(), [&](std::size_t other) {
      return solved.pairs(std::min(run, other), std::max(run, other)).alignment.confidence >=
             kSureConfidence;
    });
    return 2 * std::size_t(sure) > others.size();
  }

  const WallMap &old_, &new_;
  bool isPlaceSure_ = false;
  bool isThroughSite_ = false;
  std::vector<BendField> fields_;
};

}  // namespace

std::string nameOf(CarryState state) {
  switch (state) {
    case CarryState::carried:
      return "carried";
    case CarryState::unsure:
      return "unsure";
    case CarryState::gone:
      return "gone";
    case CarryState::unseen:
      break;
  }
  return "unseen";
}

std::vector<CarriedPlace> carryPlaces(const std::vector<Place>& places, const SolvedSite& solved,
                                      const RealPoses& real, std::size_t from, std::size_t to) {
  const Carrier carrier(solved, real, from, to);
  std::vector<CarriedPlace> carried;
  for (const Place& place : places) carried.push_back(carrier.carry(place));
  return carried;
}

}  // namespace roomgraph
