#pragma once
#include <map>

#include "roomgraph/align/wall_map.h"

namespace roomgraph {

/** Maps that walls can be looked up in: a bare one is completed, once, for as long as this lives.
 *  Each job has its own. */
class FullMaps {
 public:
  /** The map itself, or, of a bare one, a complete copy. O(cells) the first time. */
  const WallMap& operator()(const WallMap& map) {
    if (!map.isBare()) return map;
    const auto [made, isNew] = made_.try_emplace(&map, map);
    if (isNew) addLookUp(made->second);
    return made->second;
  }

 private:
  std::map<const WallMap*, WallMap> made_;
};

}  // namespace roomgraph
