#include "roomgraph/repair/CellVotes.h"

namespace roomgraph {

void CellVotes::addBeam(Point eye, Point end) {
  passBeam(frame_, eye, end, [&](std::size_t cell) { ++votes_[cell].passes; });
  ++votes_[frame_.index(frame_.cellAt(end))].hits;
}

}  // namespace roomgraph
