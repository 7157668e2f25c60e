#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/archive/Archive.h"

namespace roomgraph {

/** A run that a list names. */
struct ListedRun {
  std::string site, file, robot;
  std::optional<double> time;  ///< [s since 1970]; none where the list does not tell
};

/** What is to be done for one site: its new runs are compared with each other and with the record.
 *  The same task gives the same bytes wherever and however often it is done. */
struct FleetTask {
  std::string site;
  /** Hash of the maps, their names, all options and the program's version: 64 hex digits. */
  std::string key;
  std::vector<RunOrigin> runs;  ///< the new ones first
  std::size_t newRuns = 0;      ///< how many are new
};

}  // namespace roomgraph
