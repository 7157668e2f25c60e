#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings.h"
#include "read_maps.h"
#include "roomgraph/drawing/draw.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph {
namespace {

namespace py = pybind11;
using Unlocked = py::call_guard<py::gil_scoped_release>;

Stages extractMap(const PythonMap& map, const PythonCall& call) {
  const ExtractOptions options = optionsOf(call).extract;
  return extractGraph(readGrid(map, call, options.loadGrid), options);
}

/** A copy of the labels as rows and columns. */
py::array_t<std::uint16_t> labelsOf(const Stages& stages) {
  const GridFrame& frame = stages.grid.frame;
  const std::vector<std::uint16_t>& labels = stages.areas.labels;
  py::array_t<std::uint16_t> array({frame.height, frame.width});
  std::copy(labels.begin(), labels.end(), array.mutable_data());
  return array;
}

}  // namespace

void bindExtract(py::module_& module) {
  py::class_<Stages>(module, "Stages")
      .def("json", [](const Stages& stages) { return graphJson(stages); })
      .def("labels", &labelsOf)
      .def("png", [](const Stages& stages) { return py::bytes(drawPng(stages)); })
      .def("svg", [](const Stages& stages) { return drawSvg(stages); });
  module.def("extract", &extractMap, py::arg("map"), py::arg("call"), Unlocked());
}

}  // namespace roomgraph
