#include "OnDemand.h"

namespace roomgraph {

extern "C" __attribute__((visibility("default"))) const OnDemandLibrary<WithCeres>
    roomgraph_on_demand = {ROOMGRAPH_VERSION, {solvePoseGraph}};

}  // namespace roomgraph
