#pragma once
#include <cstddef>

namespace roomgraph {

/** Whether a run of so many scans is of one drive with runs that have `same` of them, too: several
 *  programs over one log, for example. */
inline bool sharesDrive(std::size_t same, std::size_t scans) {
  constexpr double kShared = 0.2;
  return double(same) > kShared * double(scans);
}

}  // namespace roomgraph
