#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** The word that was most likely meant: the one that takes the fewest letters changed, left out,
 *  put in or swapped with their neighbour, of equal ones the first. Empty where even that one needs
 *  more than a third of the letters of `typed`. */
std::string nearestWord(const std::string& typed, const std::vector<std::string>& words);

}  // namespace roomgraph
