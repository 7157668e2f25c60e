#include "read_maps.h"

#include <algorithm>
#include <set>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/Workers.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/compare/prepare_run.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

namespace py = pybind11;

/** Adds the run of an array. @throws DataError where it has no wall. */
void addArray(const ArrayMap& array, const ExtractOptions& options, std::vector<Run>& runs) {
  runs.push_back(prepareRun(array.map.source.file, array.map, {}, options));
}

void addOrLeaveOut(const ArrayMap& array, const PythonCall& call, const ExtractOptions& options,
                   ReadRuns& read) {
  try {
    addArray(array, options, read.runs);
  } catch (const DataError& error) {
    tell(call, true, error.what());
    const std::string& name = array.map.source.file;
    read.leftOut.push_back({name, name, error.what()});
  }
}

/** The place of the run of this name in the order of sortRuns, which they are brought into. */
std::optional<std::size_t> sortWithReference(std::vector<Run>& runs,
                                             const std::optional<std::string>& reference) {
  sortRuns(runs);
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i].name == reference) return i;
  return std::nullopt;
}

/** Sets SECTION.KEY. */
void set(FieldTable& table, const std::string& name, const std::string& value) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  if (dot == name.size())
    throw UsageError(name + ": write options as SECTION.KEY, as 'roomgraph config' lists them");
  table.set(name.substr(0, dot), name.substr(dot + 1), value);
}

}  // namespace

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

ForEach onPythonThreads(unsigned threads, const py::object& progress) {
  return [threads, &progress](std::size_t count, const std::function<void(std::size_t)>& job) {
    Workers workers(threads, count, job);
    std::size_t told = count + 1;
    workers.wait([&](std::size_t done) {
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress.is_none() && done != told) progress(told = done, count);
    });
  };
}

CompareMapsOptions optionsOf(const PythonCall& call) {
  CompareMapsOptions options;
  options.extract = preset(call.preset);
  FieldTable table = describe(options);
  for (const auto& [name, value] : call.settings) {
    set(table, name, value);
    options.extract.loadGrid.isResolutionGiven |= name == "load_grid.resolution";
  }
  options.compare.forEach = onPythonThreads(call.threads, call.progress);
  options.onUnread = [&call](const LeftOutRun& run) {
    tell(call, true, run.file + ": " + run.reason);
  };
  options.onNote = [&call](const std::string& file, const Note& note) {
    tell(call, note.isWarning, file + ": " + note.text);
  };
  return options;
}

void tell(const PythonCall& call, bool isWarning, const std::string& text) {
  const py::gil_scoped_acquire lock;
  // Names of files need not be UTF-8.
  call.tell(isWarning, py::reinterpret_steal<py::str>(
                           PyUnicode_DecodeUTF8(text.data(), Py_ssize_t(text.size()), "replace")));
}

GreyMap readGrid(const PythonMap& map, const PythonCall& call, const LoadGridOptions& options) {
  if (const auto* array = std::get_if<ArrayMap>(&map)) return array->map;
  GreyMap read = loadGrid(fileOf(map), options);
  for (const Note& note : read.notes) tell(call, note.isWarning, fileOf(map) + ": " + note.text);
  return read;
}

ReadRuns readMaps(const std::vector<PythonMap>& maps, const std::optional<PythonMap>& reference,
                  const PythonCall& call, CompareMapsOptions& options) {
  std::vector<std::string> files;
  std::set<std::string> arrays;
  for (const PythonMap& map : maps) {
    if (std::holds_alternative<std::string>(map))
      files.push_back(fileOf(map));
    else if (!arrays.insert(fileOf(map)).second)
      throw UsageError("two maps are named " + fileOf(map) + ": name them differently");
  }
  const auto* truth = reference ? std::get_if<ArrayMap>(&*reference) : nullptr;
  if (reference && !truth) options.reference = fileOf(*reference);
  ReadRuns read;
  if (!files.empty() || !options.reference.empty()) read = readRuns(files, options);
  std::optional<std::string> name;
  if (read.reference) name = read.runs[*read.reference].name;
  for (const PythonMap& map : maps)
    if (const auto* array = std::get_if<ArrayMap>(&map))
      addOrLeaveOut(*array, call, options.extract, read);
  if (truth) {
    addArray(*truth, options.extract, read.runs);
    name = options.reference = truth->map.source.file;
  }
  if (read.runs.empty()) throw DataError("no map could be used: give maps that have walls");
  read.reference = sortWithReference(read.runs, name);
  return read;
}

Run readRun(const PythonMap& map, const PythonCall& call) {
  CompareMapsOptions options = optionsOf(call);
  options.onUnread = [](const LeftOutRun& run) { throw DataError(run.file + ": " + run.reason); };
  return readMaps({map}, std::nullopt, call, options).runs.front();
}

}  // namespace roomgraph
