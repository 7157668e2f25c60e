#pragma once
#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include "roomgraph/base/Notes.h"

namespace roomgraph {

/** Options that were given and that no map of a call had a use for. Used by all threads. */
class UnusedOptions {
 public:
  /** Whether the note is on such an option, which then need not be told of the map. */
  bool take(const Note& note);
  /** A line on stderr for each option that none of so many maps has used. */
  void tell(std::size_t maps) const;

 private:
  std::mutex mutex_;
  std::map<std::string, std::size_t> maps_;  ///< by the text of the note
};

}  // namespace roomgraph
