#include "roomgraph/base/version.h"

namespace roomgraph {

const char* version() { return ROOMGRAPH_VERSION; }

}  // namespace roomgraph
