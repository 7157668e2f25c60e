#pragma once
#include <string>

namespace roomgraph {

/** Whole lines to stdout, each made printable; names within them should be so already, as they may
 *  hold line ends. */
void print(const std::string& lines);

/** Throws DataError where not all that was printed has arrived, as on a full disk. */
void checkPrinted();

}  // namespace roomgraph
