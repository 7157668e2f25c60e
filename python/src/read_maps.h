#pragma once
#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "PythonMap.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

/** What all functions of the module are called with. */
struct PythonCall {
  std::string preset;
  std::vector<std::pair<std::string, std::string>> settings;  ///< SECTION.KEY, value
  unsigned threads = 0;
  pybind11::object tell;      ///< (isWarning, text): what is odd about a map
  pybind11::object progress;  ///< (done, count), or None
};

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
