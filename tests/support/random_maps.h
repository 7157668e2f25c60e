#pragma once
#include <cstdint>
#include <vector>

#include "MapText.h"

namespace roomgraph::test {

/** Something that is laid over a map; numbers out of range are wrapped into it. */
struct Stroke {
  unsigned kind = 0;  ///< upright wall, level wall, block, unknown patch, free patch, specks
  unsigned x = 0, y = 0, width = 0, height = 0;
};

/** A free field of `width` x `height` cells with a wall round it and the strokes on it. */
MapText painted(int width, int height, double resolution, const std::vector<Stroke>& strokes);

/** A field with random strokes; the same for the same seed, on every machine. */
MapText randomMap(std::uint32_t seed, int width, int height, double resolution);

/** Rooms of 4 m on both sides of corridors, doors of 0.9 m, walls roughened and the floor strewn
 *  with specks, about `side` cells of 0.05 m wide and high. */
MapText noisyOffice(std::uint32_t seed, int side);

}  // namespace roomgraph::test
