#pragma once
#include <string>
#include <vector>

#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

/** A rule to find rooms with. */
struct RoomRule {
  std::string name;
  ExtractOptions options;
};

inline RoomRule defaultRule() { return {"tree + clutter (default)", {}}; }

/** What each part of the default rule gives: the rules to compare it with. */
inline std::vector<RoomRule> ablatedRules() {
  RoomRule alpha{"one alpha, 1.6 m", {}}, tree{"tree, no clutter", {}};
  alpha.options.findRooms.minWidth = 1.6;
  alpha.options.clearClutter.maxSize = 0;
  tree.options.clearClutter.maxSize = 0;
  return {tree, alpha};
}

}  // namespace roomgraph
