#pragma once
#include "mrpt_results.h"
#include "roomgraph/consensus/solve_pose_graph.h"
#include "roomgraph/map_files/grid_of_scans.h"
#include "roomgraph/map_files/read_keyframe_layer.h"
#include "roomgraph/mrpt_plugin/gridmap_file.h"
#include "roomgraph/scans/read_keyframes.h"
#include "roomgraph/scans/read_run_info.h"

namespace roomgraph {

// Starting with MRPT's scenes, observations and maps, which bring OpenCV and 150 libraries more,
// takes longer than most commands, and so do the solvers of Ceres. What needs them is linked to
// libraries of their own, which the first call of any of these functions loads. In the program
// itself, on_demand.cpp has functions of the same names that pass the call on.

struct WithMrpt {
  decltype(&roomgraph::gridOfScans) gridOfScans;
  decltype(&roomgraph::readKeyframes) readKeyframes;
  decltype(&roomgraph::gridmapBytes) gridmapBytes;
  decltype(&roomgraph::graphSceneFile) graphSceneFile;
  decltype(&roomgraph::graphObjectFile) graphObjectFile;
  decltype(&roomgraph::comparisonSceneFile) comparisonSceneFile;
  decltype(&roomgraph::comparisonObjectFile) comparisonObjectFile;
  decltype(&roomgraph::addBreakFiles) addBreakFiles;
  decltype(&roomgraph::scanLog) scanLog;
};

/** Of MRPT, these need no more than its poses, which are loaded in no time. */
struct WithPoses {
  decltype(&roomgraph::readRunInfo) readRunInfo;
  decltype(&roomgraph::readKeyframeLayer) readKeyframeLayer;
};

struct WithCeres {
  decltype(&roomgraph::solvePoseGraph) solvePoseGraph;
};

/** What such a library exports, by the name roomgraph_on_demand. */
template <class Functions>
struct OnDemandLibrary {
  const char* version;  ///< of roomgraph: that of the program is the same
  Functions functions;
};

}  // namespace roomgraph
