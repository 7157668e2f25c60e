#include "roomgraph/align/WallPatches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace roomgraph {
namespace {

using Square = std::pair<int, int>;
using Squares = std::map<Square, std::uint32_t>;  // to the patch

/** Calls `visit` with the patch of every square that is at most `by` squares away. */
template <class Visit>
void forSquaresAround(const Squares& squares, Square at, int by, const Visit& visit) {
  for (int x = at.first - by; x <= at.first + by; ++x)
    for (int y = at.second - by; y <= at.second + by; ++y)
      if (const auto it = squares.find({x, y}); it != squares.end()) visit(it->second);
}

Point meanOf(const std::vector<WallPoint>& walls, const std::vector<std::uint32_t>& some) {
  Point sum;
  for (const std::uint32_t i : some) sum = sum + walls[i].place;
  return (1.0 / double(some.size())) * sum;
}

std::vector<std::uint32_t> evenly(const std::vector<std::uint32_t>& all, int count) {
  if (all.size() <= std::size_t(count)) return all;
  std::vector<std::uint32_t> some;
  for (int i = 0; i < count; ++i)
    some.push_back(all[std::size_t(double(i) * double(all.size()) / count)]);
  return some;
}

}  // namespace

WallPatches wallPatches(const std::vector<WallPoint>& walls) {
  Squares squares;
  std::vector<Square> squareOf;
  for (const WallPoint& wall : walls) {
    squareOf.push_back(
        {int(std::floor(wall.place.x / kPatchSide)), int(std::floor(wall.place.y / kPatchSide))});
    squares.emplace(squareOf.back(), 0);
  }
  std::uint32_t count = 0;
  for (auto& [square, patch] : squares) patch = count++;
  WallPatches patches(squares.size());
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    patches[squares.at(squareOf[i])].own.push_back(i);
  const double reach = 2 * kPatchSide;
  for (const auto& [square, index] : squares) {
    WallPatch& patch = patches[index];
    patch.middle = meanOf(walls, patch.own);
    std::vector<std::uint32_t> around;
    forSquaresAround(squares, square, 3, [&](std::uint32_t other) {
      for (const std::uint32_t i : patches[other].own)
        if (distance(walls[i].place, patch.middle) <= reach) around.push_back(i);
    });
    std::sort(around.begin(), around.end());
    patch.around = evenly(around, kMaxAround);
    forSquaresAround(squares, square, 1, [&, index = index](std::uint32_t other) {
      if (other != index) patch.neighbours.push_back(other);
    });
  }
  return patches;
}

}  // namespace roomgraph
