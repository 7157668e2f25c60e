#pragma once
#include <pybind11/numpy.h>

#include <string>
#include <variant>

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

}  // namespace roomgraph
