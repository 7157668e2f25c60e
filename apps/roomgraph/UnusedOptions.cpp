#include "UnusedOptions.h"

#include "roomgraph/map_files/load_grid.h"
#include "terminal.h"

namespace roomgraph {

bool UnusedOptions::take(const Note& note) {
  if (note.code != kUnusedOption) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++maps_[note.text];
  return true;
}

void UnusedOptions::tell(std::size_t maps) const {
  for (const auto& [text, count] : maps_)
    if (count == maps) printError("note: " + text);
}

}  // namespace roomgraph
