#pragma once
#include <pybind11/pybind11.h>

namespace roomgraph {

// Each adds some functions to the module; _core.pyi says what they take and give.
void bindExtract(pybind11::module_& module);
void bindCompare(pybind11::module_& module);
void bindSite(pybind11::module_& module);

}  // namespace roomgraph
