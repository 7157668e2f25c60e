#include "keep_shape.h"

#include <algorithm>
#include <numeric>

#include "fitted_repair.h"
#include "roomgraph/repair/BendField.h"

namespace roomgraph {
namespace {

/** The nearest others of each place, from the nearest on. */
std::vector<std::vector<std::size_t>> neighboursOf(const std::vector<Transform2D>& places) {
  std::vector<std::vector<std::size_t>> neighbours;
  std::vector<std::size_t> others(places.size());
  for (const Transform2D& place : places) {
    std::iota(others.begin(), others.end(), std::size_t(0));
    const auto far = [&](std::size_t k) { return squaredNorm(places[k].shift() - place.shift()); };
    const std::size_t count = std::min(fitted::kNeighbours + 1, others.size());
    std::partial_sort(others.begin(), others.begin() + std::ptrdiff_t(count), others.end(),
                      [&](std::size_t l, std::size_t r) {
                        return std::make_pair(far(l), l) < std::make_pair(far(r), r);
                      });
    std::vector<std::size_t>& nearest = neighbours.emplace_back();
    for (std::size_t i = 0; i < count; ++i)
      if (&places[others[i]] != &place) nearest.push_back(others[i]);
  }
  return neighbours;
}

}  // namespace

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
        return std::size_t(std::count_if(words.begin(), words.end(), [&](const Transform2D& word) {
          return distance(word.shift(), pose.shift()) < BendField::kSameCopy;
        }));
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
