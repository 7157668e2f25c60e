#include <pybind11/stl.h>

#include <filesystem>
#include <memory>

#include "bindings.h"
#include "read_maps.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/page/comparison_report.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/run_check_json.h"

namespace roomgraph {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;
using Unlocked = py::call_guard<py::gil_scoped_release>;

constexpr char kJson[] = "comparison.json", kReport[] = "report.html";

/** A comparison with the maps that it is of. */
struct PythonComparison {
  Comparison comparison;
  std::vector<Run> runs;

  /** What is saved in a folder, as the program saves it there. */
  Comparison savedIn(const fs::path& folder, std::vector<std::string> files) const {
    Comparison saved = comparison;
    std::error_code error;
    for (ComparedRun& run : saved.runs)
      if (fs::exists(run.file, error))
        run.relativePath = fs::relative(run.file, folder, error).generic_string();
    saved.files = std::move(files);
    return saved;
  }

  std::string json() const { return comparisonJson(savedIn(".", {kJson})); }

  std::string report(const std::string& json) const {
    return comparisonReport(parseComparisonJson(json, kJson), runs);
  }

  void write(const std::string& folder) const {
    makeWritableFolder(folder);
    const std::string json = comparisonJson(savedIn(folder, {kReport, kJson}));
    writeFileAtomically((fs::path(folder) / kReport).string(), report(json));
    writeFileAtomically((fs::path(folder) / kJson).string(), json);
  }
};

std::unique_ptr<PythonComparison> compare(const std::vector<PythonMap>& maps,
                                          const std::optional<PythonMap>& reference,
                                          const PythonCall& call) {
  if (maps.size() + (reference ? 1 : 0) < 2)
    throw UsageError("compare: give at least two maps, or one and a reference");
  CompareMapsOptions options = optionsOf(call);
  ReadRuns read = readMaps(maps, reference, call, options);
  Comparison comparison = compareMaps(read, options);
  return std::make_unique<PythonComparison>(
      PythonComparison{std::move(comparison), std::move(read.runs)});
}

std::string check(const PythonMap& map, const PythonCall& call) {
  return runCheckJson(checkRun(readRun(map, call)));
}

}  // namespace

void bindCompare(py::module_& module) {
  py::class_<PythonComparison>(module, "Comparison")
      .def("json", &PythonComparison::json, Unlocked())
      .def("text", [](const PythonComparison& self) { return comparisonText(self.comparison); })
      .def(
          "report",
          [](const PythonComparison& self) {
            return self.report(comparisonJson(self.savedIn(".", {kReport})));
          },
          Unlocked())
      .def("write", &PythonComparison::write, py::arg("folder"), Unlocked());
  module.def("compare", &compare, py::arg("maps"), py::arg("reference"), py::arg("call"),
             Unlocked());
  module.def("check", &check, py::arg("map"), py::arg("call"), Unlocked());
  module.def(
      "read_comparison",
      [](const std::string& file) { return comparisonJson(readComparison(file)); }, py::arg("file"),
      Unlocked());
}

}  // namespace roomgraph
