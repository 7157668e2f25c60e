#include <pybind11/stl.h>

#include "bindings.h"
#include "read_maps.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/version.h"

namespace py = pybind11;
using roomgraph::ArrayMap;
using roomgraph::PythonCall;

PYBIND11_MODULE(_core, module) {
  module.attr("version") = roomgraph::version();
  py::register_exception<roomgraph::UsageError>(module, "UsageError", PyExc_ValueError).doc() =
      "What was asked for cannot be done: what, which value, what would do.";
  py::register_exception<roomgraph::DataError>(module, "DataError").doc() =
      "What a file holds cannot be used: which file, why, what would do.";
  py::class_<ArrayMap>(module, "ArrayMap")
      .def(py::init(&roomgraph::arrayMap), py::arg("name"), py::arg("sha256"), py::arg("grey"),
           py::arg("resolution"), py::arg("x"), py::arg("y"));
  py::class_<PythonCall>(module, "Call")
      .def(py::init([](const std::string& preset,
                       const std::vector<std::pair<std::string, std::string>>& settings,
                       unsigned threads, const py::object& tell, const py::object& progress) {
             return PythonCall{preset, settings, threads, tell, progress};
           }),
           py::arg("preset"), py::arg("settings"), py::arg("threads"), py::arg("tell"),
           py::arg("progress"));
  roomgraph::bindExtract(module);
  roomgraph::bindCompare(module);
  roomgraph::bindSite(module);
}
