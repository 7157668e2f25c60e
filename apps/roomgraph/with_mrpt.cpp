#include "OnDemand.h"

namespace roomgraph {

extern "C" __attribute__((visibility("default"))) const OnDemandLibrary<WithMrpt>
    roomgraph_on_demand = {
        ROOMGRAPH_VERSION,
        {gridOfScans, readKeyframes, gridmapBytes, graphSceneFile, graphObjectFile,
         comparisonSceneFile, comparisonObjectFile, addBreakFiles, scanLog}};

}  // namespace roomgraph
