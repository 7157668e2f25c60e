#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/Notes.h"

namespace roomgraph {

/** A note on a map. */
struct MapNote {
  std::string file;
  Note note;
};

/** For stderr: one line per note when verbose, else at most one per map, for the first of its notes
 *  of a kind that was not told yet, and how many more there are. */
std::string noteLines(const std::vector<MapNote>& notes, bool isVerbose);

}  // namespace roomgraph
