#pragma once
#include <optional>
#include <string>

#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

/** "wall_on_both_sides", "wall_on_one_side", "narrowing", "mouth" or "unseen_side", as in all
 *  files. */
[[nodiscard]] const char* reasonName(PassageReason reason);

/** The reason of that name; none for any other text. */
[[nodiscard]] std::optional<PassageReason> reasonOfName(const std::string& name);

}  // namespace roomgraph
