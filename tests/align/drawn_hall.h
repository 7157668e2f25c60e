#pragma once
#include "sampled_grid.h"

namespace roomgraph::test {

/** A hall of 8 m by 6 m, walls of `thickness`, and a line of wall `gap` in front of its south wall
 *  from x = 1 to x = 5. */
inline Grid drawnHall(double thickness, double gap) {
  return sampledGrid({200, 160, 0.05, {-1, -1}}, [&](Point p) {
    const bool isIn = p.x > 0 && p.x < 8 && p.y > 0 && p.y < 6;
    const bool isNear =
        p.x > -thickness && p.x < 8 + thickness && p.y > -thickness && p.y < 6 + thickness;
    const bool isCopy = p.x > 1 && p.x < 5 && p.y > gap && p.y < gap + 0.1;
    if (isIn) return gap > 0 && isCopy ? State::occupied : State::free;
    return isNear ? State::occupied : State::unknown;
  });
}

}  // namespace roomgraph::test
