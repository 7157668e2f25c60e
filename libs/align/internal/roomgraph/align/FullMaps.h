#pragma once
#include <cstddef>
#include <map>
#include <vector>

#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/ForEach.h"

namespace roomgraph {

/** Maps that walls can be looked up in: of each bare one a complete copy is made, once, for as long
 *  as this lives. */
class FullMaps {
 public:
  /** The map itself, or, of a bare one, its copy. Not for two threads at once. O(cells) the first
   *  time. */
  const WallMap& operator()(const WallMap& map) {
    if (!map.isBare()) return map;
    const auto [made, isNew] = made_.try_emplace(&map, map);
    if (isNew) addLookUp(made->second);
    return made->second;
  }

  /** The same, but bare where no copy has been made. */
  const WallMap& known(const WallMap& map) const {
    const auto made = made_.find(&map);
    return made == made_.end() ? map : made->second;
  }

  /** Makes the copies of several maps. */
  void complete(const std::vector<const WallMap*>& maps, const ForEach& forEach) {
    std::vector<WallMap*> bare;
    for (const WallMap* map : maps)
      if (map->isBare())
        if (const auto [made, isNew] = made_.try_emplace(map, *map); isNew)
          bare.push_back(&made->second);
    forEach(bare.size(), [&](std::size_t i) { addLookUp(*bare[i]); });
  }

 private:
  std::map<const WallMap*, WallMap> made_;
};

}  // namespace roomgraph
