#pragma once
#include <vector>

#include "roomgraph/mrpt_plugin/CMapComparison.h"

namespace roomgraph {

/** The name of the set with the walls of a run: no other set has it, whatever the run is named. */
std::string runLayer(const std::string& run);

/** The walls of each run. */
RunWalls runWalls(const std::vector<Run>& runs);

/** The runs laid on each other, in the frame of the site [m], in one set of objects named
 *  "comparison". In it, for each run a set runLayer() with its pose holds the middles of its wall
 *  cells, in the colour that it has in the report, the best on top, a few centimetres apart. Then
 *  "rooms" (outlines), "room names" and "breaks" (rings in the colour of the run, with the key
 *  frame from which on it breaks), where there are any, and "legend" (the names of the first
 *  kMostNamed runs in their colours, below the maps). Words are to be read by a camera that is
 *  turned back by `turn` [rad]. A run without walls is not drawn. O(walls). */
viz::CSetOfObjects::Ptr drawComparison(const Comparison& comparison, const RunWalls& walls,
                                       double turn = 0);

constexpr std::size_t kMostNamed = 14;  ///< runs have colours of their own
constexpr double kLegendLine = 1.6;     ///< a line of the legend, in heights of its letters

/** Of all words on a site [m]. */
double letterHeight(const Box& box);

/** The smallest upright box round all walls, in the frame of the site turned by `turn` [rad] about
 *  its origin; a square metre round the origin for nothing. */
Box drawnBox(const Comparison& comparison, const RunWalls& walls, double turn = 0);

}  // namespace roomgraph
