#include "PythonMap.h"

#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"

namespace roomgraph {

ArrayMap arrayMap(const std::string& name, const std::string& sha256,
                  const pybind11::array_t<std::uint8_t, pybind11::array::c_style |
                                                            pybind11::array::forcecast>& grey,
                  double resolution, double x, double y) {
  if (grey.ndim() != 2 || grey.size() == 0 || std::size_t(grey.size()) > kMostCells)
    throw UsageError(name + ": is no array of rows and columns with 1 to 400 million cells");
  ArrayMap array;
  GreyMap& map = array.map;
  map.frame = {int(grey.shape(1)), int(grey.shape(0)), resolution, {x, y}};
  if (!map.frame.isSane())
    throw UsageError(name +
                     ": give the side of a cell as resolution (0.0001 to 1000 m), and its lower "
                     "left corner as origin [m]");
  map.grey.assign(grey.data(), grey.data() + grey.size());
  map.source.file = name, map.source.kind = "array", map.source.sha256 = sha256;
  return array;
}

const std::string& fileOf(const PythonMap& map) {
  const auto* file = std::get_if<std::string>(&map);
  return file ? *file : std::get<ArrayMap>(map).map.source.file;
}

}  // namespace roomgraph
