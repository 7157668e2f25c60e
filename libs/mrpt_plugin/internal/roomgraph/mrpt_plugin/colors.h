#pragma once
#include <cstddef>
#include <cstdint>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** What the parts of a graph look like in 3D; told apart also by the colour-blind. */
struct Color {
  std::uint8_t r = 0, g = 0, b = 0;
};

constexpr Color kCorridorColor{0, 82, 155};      ///< ways outside of rooms
constexpr Color kRoomWayColor{84, 105, 120};     ///< ways from a room's vertex to its borders
constexpr Color kRoomOutlineColor{92, 99, 112};  ///< rings of the rooms' polygons
constexpr Color kRimColor{255, 255, 255};        ///< round each vertex
constexpr Color kNumberColor{255, 255, 255};     ///< of the rooms
constexpr Color kBackgroundColor{236, 239, 243};
constexpr std::uint8_t kFreeGrey = 255, kUnknownGrey = 205, kOccupiedGrey = 45;

/** A vertex by its kind. */
constexpr Color vertexColor(VertexKind kind) {
  switch (kind) {
    case VertexKind::junction:
      return {0, 114, 178};
    case VertexKind::deadEnd:
      return {230, 159, 0};
    case VertexKind::border:
      return {213, 94, 0};
    case VertexKind::room:
      return {0, 110, 82};
    case VertexKind::ring:
      return {160, 80, 150};
  }
  return {};
}

/** The floor of a room by its id; neighbouring ids differ. */
constexpr Color roomColor(std::size_t room) {
  constexpr Color floors[] = {{190, 224, 205}, {250, 222, 178}, {196, 214, 240}, {244, 205, 212},
                              {222, 232, 176}, {221, 206, 236}, {184, 226, 228}, {240, 218, 200}};
  return floors[room % (sizeof floors / sizeof floors[0])];
}

}  // namespace roomgraph
