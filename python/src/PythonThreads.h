#pragma once
#include <pybind11/pybind11.h>

#include "roomgraph/base/ForEach.h"

namespace roomgraph {

/** Jobs on so many threads, 0 for one per core. To be called without Python's lock, which is taken
 *  now and then: to call `progress(done, count)`, unless it is None, and to look for Ctrl-C. What
 *  these throw ends the work: no further job begins, and it is thrown again. `progress` must
 *  outlive the result. */
ForEach onPythonThreads(unsigned threads, const pybind11::object& progress);

}  // namespace roomgraph
