#pragma once
#include <mrpt/img/TColor.h>

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "roomgraph/drawing/ink.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

constexpr mrpt::img::TColor mrptColour(Colour c) { return {c.red, c.green, c.blue}; }

// What the parts of a graph look like in 3D; told apart also by the colour-blind.
constexpr Colour kCorridorColour{0, 82, 155};      ///< ways outside of rooms
constexpr Colour kRoomWayColour{84, 105, 120};     ///< ways from a room's vertex to its borders
constexpr Colour kRoomOutlineColour{92, 99, 112};  ///< rings of the rooms' polygons
constexpr Colour kRimColour{255, 255, 255};        ///< round each vertex, and of rooms' numbers
constexpr Colour kBackgroundColour{236, 239, 243};
constexpr std::uint8_t kFreeGrey = 255, kUnknownGrey = 205, kOccupiedGrey = 45;

/** A vertex by its kind. */
constexpr Colour vertexColour(VertexKind kind) {
  constexpr Colour kinds[] = {ink::blue, ink::orange, ink::vermilion, {0, 110, 82}, {160, 80, 150}};
  static_assert(std::size(kinds) == std::size_t(VertexKind::ring) + 1);
  return kinds[std::size_t(kind)];
}

/** The floor of a room by its id; neighbouring ids differ. */
constexpr Colour roomColour(std::size_t room) {
  constexpr Colour floors[] = {{190, 224, 205}, {250, 222, 178}, {196, 214, 240}, {244, 205, 212},
                               {222, 232, 176}, {221, 206, 236}, {184, 226, 228}, {240, 218, 200}};
  return floors[room % std::size(floors)];
}

}  // namespace roomgraph
