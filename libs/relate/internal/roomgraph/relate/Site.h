#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/align/FullMaps.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** The runs of a site in one frame. */
struct Site {
  std::vector<const Run*> runs;
  std::vector<Transform2D> poses;        ///< site <- run
  std::vector<std::size_t> members;      ///< their places among all runs, ascending
  std::optional<std::size_t> reference;  ///< of `runs`: the one that counts as the truth
  /** Runs that lie in each other but not in this site, two or more together: their places among all
   *  runs, ascending. */
  std::vector<std::vector<std::size_t>> others{};
  /** Of the runs of the core that came with a bare map: the map with all there is. */
  FullMaps fullMaps{};

  /** The place of the run that came from this file among `runs`; none where it is not of the site.
   */
  std::optional<std::size_t> placeOf(const std::string& file) const {
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (runs[i]->file == file) return i;
    return std::nullopt;
  }
  /** Whether it is of the site, by its place among all runs. */
  bool has(std::size_t run) const {
    return std::binary_search(members.begin(), members.end(), run);
  }
  /** Bare at most for a run that is not of the core. */
  const WallMap& mapOf(std::size_t run) const { return fullMaps.known(runs[run]->map); }
};

/** How much the word of each run of a site counts in what is said of the others: 0 to 1. */
using Trust = std::vector<double>;

}  // namespace roomgraph
