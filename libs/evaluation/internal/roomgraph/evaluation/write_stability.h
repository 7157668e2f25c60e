#pragma once
#include <string>

#include "roomgraph/evaluation/stability.h"

namespace roomgraph {

// Paper, tables 1 to 5
// In:   Stability
// Out:  the text of files, and of a table for people
//
// Distances are in cells, as in the paper; shares in percent.

/** Columns distance_px, percent, room, no_room, ratio_percent as in the paper, then the sound
 *  measures: median, 90th percentile and unmatched shares of the one-to-one matching, with rooms
 *  and without, share of rooms found again, and change in their number. One line per row, rounded
 *  to 4 decimals; empty where there is no value. */
std::string stabilityCsv(const Stability& result);

/** The same with all runs, all options, the map's hash and the program's version; null where there
 *  is no value. Rounded to 4 decimals. Rows and runs stand on a line each. */
std::string stabilityJson(const Stability& result);

/** The paper's table, and below it the means of the sound measures. */
std::string stabilityText(const Stability& result);

}  // namespace roomgraph
