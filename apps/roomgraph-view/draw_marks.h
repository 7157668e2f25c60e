#pragma once
#include <vector>

#include "View.h"
#include "ViewState.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** The line that is measured, with a dot at each corner. */
viz::CSetOfObjects::Ptr drawRuler(const std::vector<Point>& corners);

/** The outline of the room that was clicked, the vertex or the path, and a dot where the click was;
 *  nothing for no click. */
viz::CSetOfObjects::Ptr drawRead(const View& view, const ViewState& state);

/** Of Mode::swipe: the walls of the run left of the line, those of the other one right of it, and
 *  the line, which runs through all of `box`. `scene` has the walls of both, by their names. */
viz::CSetOfObjects::Ptr drawSwipe(const View& view, const ViewState& state, const Box& box,
                                  MrptScene& scene);

/** What an error of a key frame [m] looks like: from green over yellow to red, which it is from
 *  kWorstError on; blue where it cannot be told. */
mrpt::img::TColor colourOfError(const std::optional<double>& error);
constexpr double kWorstError = 0.5;

/** The way of the robot by the error of what was drawn from it, with a dot for each key frame. */
viz::CSetOfObjects::Ptr drawPath(const std::vector<PathPose>& path);

/** Where the runs disagree, as the heat map of the report has it: a square for each cell, pale to
 *  dark by the share of the runs that see it otherwise than the others. O(runs * cells). */
viz::CSetOfObjects::Ptr drawDisagreement(const View& view);

}  // namespace roomgraph
