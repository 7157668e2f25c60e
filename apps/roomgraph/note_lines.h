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

/** For stderr: one line per note when verbose, else one per kind of note, with how many more there
 *  are. */
std::string noteLines(const std::vector<MapNote>& notes, bool isVerbose);

}  // namespace roomgraph
