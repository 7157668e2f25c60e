#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace roomgraph {

/** Something odd but legal that a step met: worth telling, no reason to stop. */
struct Note {
  std::string code;                              ///< stable, snake_case, for programs
  std::string text;                              ///< one sentence for people
  std::optional<std::array<double, 2>> where{};  ///< x, y [m, map frame], where it has a place
  bool isWarning = false;  ///< the results may be of something else: told even with --quiet
};

using Notes = std::vector<Note>;  ///< in the order in which they came up

}  // namespace roomgraph
