#pragma once
#include <optional>

#include "ViewState.h"

namespace roomgraph {

/** How well the run, where it was moved to by hand, lies on the other one. */
struct NudgeFit {
  double overlap = 0;       ///< share of the smaller free space that is free in both
  double found = 0;         ///< share of the walls where the other knows what is there, found again
  double contradicted = 0;  ///< share of them that lies in the other's free space
  double score = 0;         ///< alignmentScore(): of two poses, the higher one is likelier
};

/** None where the map of one of the two is missing. A few ms. */
std::optional<NudgeFit> nudgeFit(const View& view, const ViewState& state);

/** Moves the run from where it is to where its walls fit best near by. */
void fitNudge(const View& view, ViewState& state);

}  // namespace roomgraph
