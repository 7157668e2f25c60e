#include "roomgraph/align/are_identical.h"

#include <algorithm>

namespace roomgraph {

bool areIdentical(const WallMap& l, const WallMap& r) {
  return l.states == r.states && l.walls.size() == r.walls.size() &&
         std::equal(l.walls.begin(), l.walls.end(), r.walls.begin(),
                    [](const WallPoint& p, const WallPoint& q) { return p.place == q.place; });
}

}  // namespace roomgraph
