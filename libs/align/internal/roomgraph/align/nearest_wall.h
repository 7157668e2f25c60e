#pragma once
#include "roomgraph/align/WallMap.h"

namespace roomgraph {

/** A wall that lies this near to another has been found [m]. */
constexpr double kSameWall = 0.15;

/** The same where maps bend, or where poses are known within some decimetres only [m]. */
constexpr double kSameWhereBent = 2 * kSameWall;

/** Cosine between the normals of one wall, in two scans or drawn twice. */
constexpr double kFacesAlike = 0.8;

/** How far apart the same wall lies in two maps, as a rule [m]. */
constexpr double kWallNoise = 0.12;

/** Index of the cell that holds `place`, or frame.cellCount() outside of it: GridFrame::cellAt and
 *  index in one, for the innermost loops. */
inline std::size_t cellIndexAt(const GridFrame& frame, Point place) {
  const double x = (place.x - frame.origin.x) / frame.resolution;
  const double y = (place.y - frame.origin.y) / frame.resolution;
  if (!(x >= 0 && y >= 0 && x < frame.width && y < frame.height)) return frame.cellCount();
  return frame.index({int(x), int(y)});
}

/** What a map knows of a place: nothing outside of it. */
inline State stateAt(const WallMap& map, Point place) {
  const std::size_t index = cellIndexAt(map.frame, place);
  return index < map.states.size() ? map.states[index] : State::unknown;
}

/** Every so manyth wall point of a map is one of at most `maxPoints`; 0 without any. */
inline std::size_t strideOf(const WallMap& map, int maxPoints) {
  return (map.walls.size() + std::size_t(maxPoints) - 1) / std::size_t(maxPoints);
}

/** Whether a map has seen the cell at `index`: never beyond the last one. */
inline bool hasSeen(const WallMap& map, std::size_t index) {
  return index < map.states.size() && map.states[index] != State::unknown;
}

/** The wall point near the cell at `index` that faces about as `normal` does, nearest to the middle
 *  of that cell; null where none is in reach, or beyond the last cell. O(1). */
inline const WallPoint* nearestWall(const WallMap& map, std::size_t index, Point normal) {
  if (index >= map.frame.cellCount()) return nullptr;
  const std::uint32_t wall = map.nearest[std::size_t(octantOf(normal))][index];
  return wall == kNoIndex ? nullptr : &map.walls[wall];
}

/** The same near a place. */
inline const WallPoint* nearestWall(const WallMap& map, Point place, Point normal) {
  return nearestWall(map, cellIndexAt(map.frame, place), normal);
}

}  // namespace roomgraph
