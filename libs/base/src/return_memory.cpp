#include "roomgraph/base/return_memory.h"

#include <cstdlib>  // which tells whether __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>

#include <mutex>
#endif

namespace roomgraph {

void returnMemory() {
#ifdef __GLIBC__
  // Where another allocator stands in, as a sanitizer's, the first call sets up that of the C
  // library, which two threads must not do at once.
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  malloc_trim(0);
#endif
}

}  // namespace roomgraph
