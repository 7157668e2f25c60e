#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** A name for each run, all different: X as in outputStem; where two files have the same, FOLDER/X;
 *  where that does not tell them apart, the file as it was given; a file that is given again gets
 *  "#2" and so on. The names of files do not depend on their order. */
std::vector<std::string> runNames(const std::vector<std::string>& files);

}  // namespace roomgraph
