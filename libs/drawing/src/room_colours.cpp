#include "room_colours.h"

#include <array>

#include "Pen.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr std::array<Colour, 6> kRoomColours{ink::sky,    ink::orange, ink::green,
                                             ink::purple, ink::yellow, ink::vermilion};
constexpr double kNeighbouring = 1.0;  // [m] between the boxes of two rooms

bool areNear(const Box& a, const Box& b) {
  return a.low.x - kNeighbouring < b.high.x && b.low.x - kNeighbouring < a.high.x &&
         a.low.y - kNeighbouring < b.high.y && b.low.y - kNeighbouring < a.high.y;
}

}  // namespace

std::vector<Colour> roomColours(const std::vector<const Polygon*>& rooms) {
  std::vector<Box> boxes;
  std::vector<std::size_t> choice;
  std::array<int, kRoomColours.size()> used{};
  for (const Polygon* room : rooms) {
    boxes.push_back(room->outer.empty() ? Box{} : boundingBox(room->outer));
    std::array<int, kRoomColours.size()> usedNear{};
    for (std::size_t r = 0; r < choice.size(); ++r)
      if (areNear(boxes.back(), boxes[r])) ++usedNear[choice[r]];
    std::size_t best = 0;
    for (std::size_t c = 1; c < kRoomColours.size(); ++c)
      if (std::make_pair(usedNear[c], used[c]) < std::make_pair(usedNear[best], used[best]))
        best = c;
    ++used[best];
    choice.push_back(best);
  }
  return mapped(choice, [](std::size_t c) { return kRoomColours[c]; });
}

}  // namespace roomgraph
