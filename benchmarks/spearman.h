#pragma once
#include <vector>

namespace roomgraph {

/** Spearman's rank correlation of two lists of one length; equal values share a rank. 0 where one
 *  of them is all the same. O(n^2). */
double spearman(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace roomgraph
