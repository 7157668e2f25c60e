#pragma once
#include <ctime>

namespace roomgraph {

/** CPU time of this process [s]: other programs on the machine do not count. */
inline double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

}  // namespace roomgraph
