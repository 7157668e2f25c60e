#include <pybind11/stl.h>

#include "PythonMap.h"
#include "bindings.h"
#include "read_maps.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/version.h"

namespace py = pybind11;

PYBIND11_MODULE(_core, module) {
  using namespace roomgraph;
  module.attr("version") = version();
  py::register_exception<UsageError>(module, "UsageError", PyExc_ValueError).doc() =
      "What was asked for cannot be done: what, which value, what would do.";
  py::register_exception<DataError>(module, "DataError").doc() =
      "What a file holds cannot be used: which file, why, what would do.";
  py::class_<ArrayMap>(module, "ArrayMap")
      .def(py::init(&arrayMap), py::arg("name"), py::arg("sha256"), py::arg("grey"),
           py::arg("resolution"), py::arg("x"), py::arg("y"));
  py::class_<PythonCall>(module, "Call")
      .def(
          py::init([](std::string preset, std::vector<std::pair<std::string, std::string>> settings,
                      unsigned threads, py::object tell, py::object progress) {
            return PythonCall{std::move(preset), std::move(settings), threads, std::move(tell),
                              std::move(progress)};
          }),
          py::arg("preset"), py::arg("settings"), py::arg("threads"), py::arg("tell"),
          py::arg("progress"));
  bindExtract(module);
  bindCompare(module);
  bindSite(module);
}
