#pragma once
#include <optional>
#include <vector>

#include "roomgraph/grid/Grid.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

// In:   a picture whose scale is not known, and runs of which it is
// Out:  ScaleEstimate
// Next: extract, with that scale

constexpr double kScaleStep = 0.05;          ///< between the scales that are tried, as a share
constexpr double kMinScaleConfidence = 0.4;  ///< that the picture is of the run's site
constexpr double kMinScaleMargin = 1.2;      ///< of the score before that of any other scale

/** The scale at which a picture fits the runs. */
struct ScaleEstimate {
  double resolution = 0;  ///< side of a cell of the picture [m]
  std::size_t runs = 0;   ///< how many runs say so
};

/** The same grid with cells of another size; its origin is scaled with them. */
Grid rescaled(Grid grid, double resolution);

/** Finds the side of a picture's cell. Free area, width of rooms and extent of walls, as ratios of
 *  run and picture, give a range of scales, widened to hold the first guess, which is
 *  picture.frame.resolution. All over that range the picture is aligned with a run; the best few
 *  scales are fitted to its walls, and the best of them must stand out from all others. The run is
 *  the first byStraightness, or the next where that shows another site. Then the straightest runs
 *  that the picture fits at this scale have their say: the median counts, weighted by how well each
 *  fits, as bent runs look too small.
 *
 *  Nothing where no scale stands out: another site, a picture without walls, no run. The error of
 *  the runs' own scale is part of the result; beside it about 0.3 %. A picture that repeats itself
 *  on another scale can be taken wrongly. The same for any order of the jobs; runs that are equal
 *  in size and straightness count in their order. About 35 times alignMaps. */
std::optional<ScaleEstimate> estimateScale(const Grid& picture, const std::vector<Run>& runs,
                                           const ForEach& forEach);

/** The side of a cell for pictures of one scale that none of them tells: that at which half of
 *  their free floor lies within 0.4 m of what is not free, as in most buildings (0.2 to 1 m in 50
 *  maps). So it may be wrong by a factor of two, at which pictures still lie in each other as they
 *  do at the right one. Nothing where no floor is free. O(cells). */
std::optional<double> usualScale(const std::vector<Grid>& pictures);

}  // namespace roomgraph
