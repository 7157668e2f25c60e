#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   Comparison
// Out:  the text of tables
// Next: a file

/** One line per run, best first, below a line of column names: empty fields for what cannot be
 *  told. Of each measure the value alone. The last columns list the breaks of the run, in their
 *  order and separated by ";": key frames ("-" for none), places ("x y") [m, site frame], turns
 *  [deg] and shifts [m]. */
std::string comparisonRunsCsv(const Comparison& comparison);

/** One line per room and run, by room, then as the runs, below a line of column names; empty fields
 *  for what cannot be told. */
std::string comparisonRoomsCsv(const Comparison& comparison);

}  // namespace roomgraph
