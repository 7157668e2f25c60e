#include "roomgraph/base/return_memory.h"

#include <cstdlib>  // which tells whether __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace roomgraph {

void returnMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace roomgraph
