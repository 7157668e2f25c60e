#pragma once
#include <vector>

#include "roomgraph/ledger/SiteRoom.h"

namespace roomgraph {

/** What is kept of a site from one comparison to the next: a file of format "roomgraph/site". Its
 *  frame is that of the comparison that made it, and stays. */
struct SiteFile {
  /** Without their runs, [m, frame of the file]: rooms, then corridors, each in the order they were
   *  first seen. An id is never given to another room. */
  std::vector<SiteRoom> rooms;
  int nextRoom = 1, nextCorridor = 1;  ///< numbers that no id has had yet
};

}  // namespace roomgraph
