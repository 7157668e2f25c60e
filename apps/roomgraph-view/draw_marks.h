#pragma once
#include "ViewState.h"
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

}  // namespace roomgraph
