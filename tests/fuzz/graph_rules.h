#pragma once
#include <string>
#include <vector>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph::test {

/** What a reader of the results may rely on, on any map and with any options, and does not hold:
 *  each path has two points or more, ends on its vertices and is as long as it says; edges in rooms
 *  join the room's vertex and a border vertex; border vertices lie on a ring of their rooms, or
 *  where a door joins two rooms, within half of its depth. A sentence each. O(n). */
std::vector<std::string> brokenRules(const Stages& stages);

}  // namespace roomgraph::test
