#include "PythonThreads.h"

#include "roomgraph/base/Workers.h"

namespace roomgraph {

namespace py = pybind11;

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

}  // namespace roomgraph
