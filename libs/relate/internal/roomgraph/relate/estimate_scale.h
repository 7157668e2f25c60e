#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/align_maps.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

// Ours
// In:   a picture whose scale is not known, and runs of which it is
// Out:  ScaleEstimate
// Next: extract, with that scale

/** An alignment that is good enough to tell which of several scales is right. */
AlignMapsOptions quickAlignment();

struct EstimateScaleOptions {
  double step = 0.05;          ///< between the scales that are tried, as a share
  double below = 1.25;         ///< factor by which they go below what sizes of rooms and map tell
  double above = 1.6;          ///< and above: what a run has not seen makes them look small
  double guessReach = 2;       ///< factor by which they go farther still to reach the first guess
  std::size_t closer = 3;      ///< scales that are looked at closely
  std::size_t searches = 2;    ///< runs that the picture is looked for in, until it fits one
  std::size_t voters = 5;      ///< runs that have their say at last
  double minConfidence = 0.4;  ///< siteConfidence of the pose from which on a picture may fit
  double minOverlap = 0.5;     ///< of the pose
  double minOfRun = 0.2;       ///< share of the run's free area that the picture must show, too
  double minMargin = 1.2;      ///< how much better its score must be than that of any other scale
  AlignMapsOptions quick = quickAlignment();  ///< of each scale that is tried
  AlignMapsOptions align;                     ///< of those that are looked at closely
};

/** The scale at which a picture fits the runs. */
struct ScaleEstimate {
  double resolution = 0;  ///< side of a cell of the picture [m]
  std::size_t runs = 0;   ///< how many runs say so
  std::size_t best = 0;   ///< the run that it was found in
  Alignment alignment;    ///< best <- picture, at that scale, the picture's origin being scaled too
};

/** The same grid with cells of another size; its origin is scaled with them. */
Grid rescaled(Grid grid, double resolution);

/** Finds the side of a picture's cell. Free area, width of rooms and extent of walls, as ratios of
 *  run and picture, give a range of scales, widened to hold the first guess, which is
 *  picture.frame.resolution. All over that range the picture is aligned with a run; the best few
 *  scales are fitted to its walls, and the best of them must stand out from all others. The run is
 *  the straightest of the large ones (see hubOf), or the next where that shows another site. Then
 *  the straightest runs that the picture fits at this scale have their say: the median counts,
 *  weighted by how well each fits, as bent runs look too small.
 *
 *  Nothing where no scale stands out: another site, a picture without walls, no run. The error of
 *  the runs' own scale is part of the result; beside it about 0.3 %. A picture that repeats itself
 *  on another scale can be taken wrongly. The same for any order of the jobs; runs that are equal
 *  in size and straightness count in their order. About 35 times alignMaps. */
std::optional<ScaleEstimate> estimateScale(const Grid& picture, const std::vector<Run>& runs,
                                           const EstimateScaleOptions& options,
                                           const ForEach& forEach);

}  // namespace roomgraph
