#include "OnDemand.h"

namespace roomgraph {

extern "C" __attribute__((visibility("default"))) const OnDemandLibrary<WithPoses>
    roomgraph_on_demand = {ROOMGRAPH_VERSION, {readRunInfo, readKeyframeLayer}};

}  // namespace roomgraph
