#include "roomgraph/repair/carry_things.h"

#include <algorithm>

#include "fitted_repair.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/NearPlaces.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/repair/BendField.h"
#include "roomgraph/repair/carry_places.h"

namespace roomgraph {
namespace {

/** new map <- place of all, also of those of which nothing is known. */
std::vector<Transform2D> posesOf(const std::vector<Place>& places,
                                 const std::vector<CarriedPlace>& carried,
                                 const Transform2D& rigid) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < carried.size(); ++i)
    if (carried[i].pose) known.push_back(i);
  std::vector<Transform2D> poses;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (carried[i].pose || known.empty()) {
      poses.push_back(carried[i].pose.value_or(rigid * places[i].pose));
      continue;
    }
    const auto farFrom = [&](std::size_t k) {
      return squaredNorm(places[k].pose.shift() - places[i].pose.shift());
    };
    const std::size_t nearest =
        *std::min_element(known.begin(), known.end(),
                          [&](std::size_t l, std::size_t r) { return farFrom(l) < farFrom(r); });
    poses.push_back(*carried[nearest].pose * places[nearest].pose.inverse() * places[i].pose);
  }
  return poses;
}

/** Which places are a thing by themselves, as a node of a route is. */
std::vector<bool> areThings(const MarkedFile& file) {
  std::vector<bool> are(file.places.size());
  for (const Thing& thing : file.things)
    if (thing.places.size() == 1 && thing.around.empty()) are[thing.places.front()] = true;
  return are;
}

/** The places of `near` with the least distance from a place, and among equal ones the first, in
 *  this order. */
std::vector<std::size_t> nearestOf(std::vector<std::size_t> near, std::size_t place,
                                   const std::vector<Point>& places) {
  const std::size_t count = std::min(fitted::kNeighbours + 1, near.size());
  const auto far = [&](std::size_t k) {
    return std::make_pair(squaredNorm(places[k] - places[place]), k);
  };
  std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end(),
                    [&](std::size_t l, std::size_t r) { return far(l) < far(r); });
  near.resize(count);
  eraseIf(near, [&](std::size_t k) { return k == place; });
  return near;
}

/** The nearest others of each place, from the nearest on: looked for ever farther off, until there
 *  are enough. */
std::vector<std::vector<std::size_t>> neighboursOf(const std::vector<Transform2D>& were) {
  const std::vector<Point> places = mapped(were, &Transform2D::shift);
  Box box;
  for (const Point place : places) box.include(place);
  const double widest = places.empty() ? 0 : norm(box.high - box.low);
  std::vector<std::vector<std::size_t>> neighbours(places.size());
  std::vector<std::size_t> open = numbersFrom(0, places.size());
  for (double reach = std::max(1e-3, widest / double(places.size() + 1)); !open.empty();
       reach *= 2) {
    const NearPlaces near(places, reach);
    eraseIf(open, [&](std::size_t place) {
      std::vector<std::size_t> inReach;
      near.forEachNear(places[place], [&](std::size_t k) {
        if (squaredNorm(places[k] - places[place]) <= reach * reach) inReach.push_back(k);
      });
      const bool isEnough = inReach.size() > fitted::kNeighbours || reach > widest;
      if (isEnough) neighbours[place] = nearestOf(std::move(inReach), place, places);
      return isEnough;
    });
  }
  return neighbours;
}

/** By the worst of its places; `hasMoved` tells which of them follow others. */
void tellState(CarriedThing& there, const Thing& thing, const std::vector<CarriedPlace>& carried,
               const std::vector<bool>& hasMoved) {
  there.error = 0;
  for (std::size_t i = 0; i < thing.places.size(); ++i) {
    CarriedPlace place = carried[thing.places[i]];
    if (hasMoved[i] && place.state == CarryState::carried)
      place.state = CarryState::unsure, place.reason = "its parts lie apart on the new map";
    if (place.state > there.state) there.state = place.state, there.reason = place.reason;
    if (!place.pose) there.error.reset();
    if (there.error) there.error = std::max(*there.error, place.error);
  }
}

}  // namespace

std::vector<CarriedThing> carriedThings(const MarkedFile& file,
                                        const std::vector<CarriedPlace>& carried,
                                        const Transform2D& rigid) {
  const std::vector<Transform2D> poses = posesOf(file.places, carried, rigid);
  const std::vector<bool> isThing = areThings(file);
  std::vector<CarriedThing> things;
  for (const Thing& thing : file.things) {
    CarriedThing& there = things.emplace_back();
    std::vector<Transform2D> were;
    for (const auto* places : {&thing.places, &thing.around})
      for (const std::size_t i : *places)
        were.push_back(file.places[i].pose), there.poses.push_back(poses[i]);
    const std::vector<bool> hasMoved = keepShape(were, there.poses);
    for (std::size_t i = 0; i < thing.places.size(); ++i)
      if (isThing[thing.places[i]]) there.poses[i] = poses[thing.places[i]];
    if (were.empty()) {
      there.state = CarryState::unsure, there.reason = "it has no place in its file";
      continue;
    }
    tellState(there, thing, carried, hasMoved);
  }
  return things;
}

std::vector<CarriedThing> carryThings(const MarkedFile& file, const SolvedSite& solved,
                                      const RealPoses& real, std::size_t from, std::size_t to,
                                      const ForEach& forEach) {
  const Site& site = solved.site;
  return carriedThings(file, carryPlaces(file.places, solved, real, from, to, forEach),
                       site.poses[to].inverse() * site.poses[from]);
}

std::vector<bool> keepShape(const std::vector<Transform2D>& were, std::vector<Transform2D>& poses) {
  const auto neighbours = neighboursOf(were);
  std::vector<bool> hasMoved(were.size());
  for (int pass = 0; pass < 10; ++pass) {  // shreds are narrow: few are enough
    const std::vector<Transform2D> before = poses;
    bool isDone = true;
    for (std::size_t i = 0; i < were.size(); ++i) {
      // Where it would lie if it moved like a neighbour.
      std::vector<Transform2D> words;
      for (const std::size_t k : neighbours[i])
        words.push_back(before[k] * were[k].inverse() * were[i]);
      const auto agreeing = [&](const Transform2D& pose) {
        return countIf(words, [&](const Transform2D& word) {
          return distance(word.shift(), pose.shift()) < BendField::kSameCopy;
        });
      };
      for (const Transform2D& word : words) {
        if (2 * agreeing(word) <= words.size() || 2 * agreeing(before[i]) > words.size()) continue;
        poses[i] = word, hasMoved[i] = true, isDone = false;
        break;
      }
    }
    if (isDone) break;
  }
  return hasMoved;
}

}  // namespace roomgraph
