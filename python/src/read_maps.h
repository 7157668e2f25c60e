#pragma once
#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** A map that a Python program holds as an array; see GridMap.py, which makes it. */
struct ArrayMap {
  GreyMap map;  ///< source.file is its name
};

/** The cells row by row, row 0 lowest: 0 surely occupied, 255 surely free.
 *  @throws UsageError for an array that is empty or too large, and a cell without a side. */
ArrayMap arrayMap(const std::string& name, const std::string& sha256,
                  const pybind11::array_t<std::uint8_t, pybind11::array::c_style |
                                                            pybind11::array::forcecast>& grey,
                  double resolution, double x, double y);

/** A file, or an array. */
using PythonMap = std::variant<std::string, ArrayMap>;

/** The name of its file, or of the array. */
const std::string& fileOf(const PythonMap& map);

/** What all functions of the module are called with. */
struct PythonCall {
  std::string preset;
  std::vector<std::pair<std::string, std::string>> settings;  ///< SECTION.KEY, value
  unsigned threads = 0;
  pybind11::object tell;      ///< (isWarning, text): what is odd about a map
  pybind11::object progress;  ///< (done, count), or None
};

/** Jobs on so many threads, 0 for one per core. To be called without Python's lock, which is taken
 *  now and then: to call `progress(done, count)`, unless it is None, and to look for Ctrl-C. What
 *  these throw ends the work: no further job begins, and it is thrown again. `progress` must
 *  outlive the result. */
ForEach onPythonThreads(unsigned threads, const pybind11::object& progress);

/** The options of a call, which must outlive them.
 *  @throws UsageError for an unknown name, or a value out of range. */
CompareMapsOptions optionsOf(const PythonCall& call);

/** Calls `tell` of the call, for which Python's lock is taken. */
void tell(const PythonCall& call, bool isWarning, const std::string& text);

/** The grid of a map, with its notes told. @throws DataError like loadGrid. */
GreyMap readGrid(const PythonMap& map, const PythonCall& call, const LoadGridOptions& options);

/** What readRuns gives of files, and the same of arrays; sets the reference of `options`. What
 *  cannot be used is left out, and told. Without Python's lock.
 *  @throws DataError where no map at all, or the reference, can be used. */
ReadRuns readMaps(const std::vector<PythonMap>& maps, const std::optional<PythonMap>& reference,
                  const PythonCall& call, CompareMapsOptions& options);

/** One run. Without Python's lock. @throws DataError where it cannot be used. */
Run readRun(const PythonMap& map, const PythonCall& call);

}  // namespace roomgraph
