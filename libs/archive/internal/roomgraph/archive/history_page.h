#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/export_history.h"

namespace roomgraph {

// In:   WatchedSite
// Out:  a page for a browser
// Next: a file

/** One HTML file that needs no other file, no network and no script: the robots, those that need a
 *  look first; then for each site, at most twenty, its map errors over time, the rooms that have
 *  changed and the latest runs. `options` are those that the sites were judged with. Whatever names
 *  contain is shown as text, files without their folders. The same input gives the same bytes.
 *  O(runs). */
std::string historyPage(const std::vector<WatchedSite>& sites, const WatchOptions& options);

}  // namespace roomgraph
