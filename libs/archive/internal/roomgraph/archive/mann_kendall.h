#pragma once
#include "roomgraph/archive/Sample.h"

namespace roomgraph {

// Mann 1945, Kendall 1975
// In:   Samples
// Out:  TrendTest
// Next: watchErrors

/** Whether values rise or fall with time. */
struct TrendTest {
  double tau = 0;        ///< pairs that rise less those that fall, as a share of all; -1 to 1
  double pRising = 0.5;  ///< how likely values without a trend rise as much as these do, 0 to 1
};

/** The test of Mann and Kendall with the normal approximation and the usual correction, which
 *  counts values that are the same. It asks for the order of the values alone, so one bad value
 *  weighs no more than any other. Samples must be in the order of time; fewer than three, or values
 *  that are all the same, have no trend. O(samples^2). */
TrendTest mannKendall(const Samples& samples);

}  // namespace roomgraph
