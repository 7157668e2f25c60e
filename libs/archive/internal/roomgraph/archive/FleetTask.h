#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/archive/Archive.h"

namespace roomgraph {

/** Sites with a run of each that a list names. Its hash is not known yet, and its time is NaN where
 *  the list does not tell. */
using RunList = std::vector<std::pair<std::string, HistoryRun>>;

/** What is to be done for one site: its new runs are compared with each other and with the record.
 *  The same task gives the same bytes wherever and however often it is done. */
struct FleetTask {
  std::string site;
  /** Hash of the maps, their names, all options and the program's version: 64 hex digits. */
  std::string key;
  std::vector<HistoryRun> runs;  ///< the new ones first
  std::size_t newRuns = 0;       ///< how many are new
};

}  // namespace roomgraph
