#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "bindings.h"
#include "read_maps.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/repair/carry_places.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/repair/repair_site.h"
#include "roomgraph/repair/solve_runs.h"

namespace roomgraph {
namespace {

namespace py = pybind11;
using Unlocked = py::call_guard<py::gil_scoped_release>;

/** Runs, and what they know together. `solved` names those of `read`, which stay where they are. */
struct Solved {
  ReadRuns read;
  SolvedSite site;
};

/** With `areOneSite`, as the caller says. */
std::unique_ptr<Solved> solve(const std::vector<PythonMap>& maps,
                              const std::optional<PythonMap>& reference, const PythonCall& call,
                              bool areOneSite = false) {
  CompareMapsOptions options = optionsOf(call);
  ReadRuns read = readMaps(maps, reference, call, options);
  options.compare.reference = read.reference;
  SolvedSite site = solveRuns(read.runs, options.compare, areOneSite);
  std::unique_ptr<Solved> solved(new Solved{std::move(read), std::move(site)});
  for (std::size_t i = 0; i < solved->read.runs.size(); ++i)
    if (!solved->site.site.has(i))
      tell(call, true,
           solved->read.runs[i].file + ": does not lie in the site of the others: left out");
  return solved;
}

/** A run after its repair, and its file. */
struct MendedRun {
  std::string name, file, simplemap, tum;
  RepairedRun repaired;
};

MendedRun mendedRun(const Run& run, const RepairedRun& repaired) {
  MovedRun moved = movedRun(run, repaired);
  return {run.name, run.file, std::move(moved.simplemap), std::move(moved.tum), repaired};
}

/** A run by what it saw twice. */
MendedRun repairedAlone(const PythonMap& map, const PythonCall& call) {
  const Run run = readRun(map, call);
  if (run.scans.empty()) throw DataError(run.file + ": has no scans: give a simplemap");
  return mendedRun(run, repairAlone(run, checkRun(run)));
}

std::vector<MendedRun> repair(const std::vector<PythonMap>& maps,
                              const std::optional<PythonMap>& reference, const PythonCall& call) {
  if (maps.size() == 1 && !reference) return {repairedAlone(maps.front(), call)};
  const auto solved = solve(maps, reference, call);
  std::vector<MendedRun> mended;
  for (const RepairedRun& repaired : repairRuns(solved->site, rejoinPieces(solved->site)))
    mended.push_back(mendedRun(solved->read.runs[repaired.run], repaired));
  if (mended.empty())
    throw DataError("repair: no run has scans and lies in the site of the others: give simplemaps");
  return mended;
}

py::dict dictOf(const MendedRun& run) {
  const RepairedRun& repaired = run.repaired;
  const auto count = py::ssize_t(repaired.poses.size());
  py::array_t<double> poses({count, py::ssize_t(3)});
  auto rows = poses.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < count; ++i) {
    const Transform2D& pose = repaired.poses[std::size_t(i)];
    rows(i, 0) = pose.x, rows(i, 1) = pose.y, rows(i, 2) = pose.phi;
  }
  py::dict dict;
  dict["name"] = run.name, dict["file"] = run.file;
  dict["state"] = nameOf(repaired.state), dict["reason"] = repaired.reason;
  dict["moved"] = repaired.moved, dict["moved_most"] = repaired.movedMost;
  dict["moved_most_at"] = repaired.movedMostAt, dict["left"] = repaired.left;
  dict["poses"] = poses;
  dict["simplemap"] = py::bytes(run.simplemap), dict["tum"] = run.tum;
  return dict;
}

/** The place of a map in the site. */
std::size_t placeIn(const Site& site, const PythonMap& map) {
  if (const auto place = site.placeOf(fileOf(map))) return *place;
  throw DataError(fileOf(map) +
                  ": does not fit the other map, so nothing can be carried: name runs that overlap "
                  "both as 'via'");
}

/** Whether a map is to be carried to itself. */
bool areSameArray(const PythonMap& one, const PythonMap& other) {
  const auto* a = std::get_if<ArrayMap>(&one);
  const auto* b = std::get_if<ArrayMap>(&other);
  return a && b && fileOf(one) == fileOf(other) && a->map.source.sha256 == b->map.source.sha256;
}

using NamedPose = std::tuple<std::string, double, double, double>;

std::vector<CarriedPlace> carry(const std::vector<NamedPose>& poses, const PythonMap& from,
                                const PythonMap& to, const std::vector<PythonMap>& via,
                                const PythonCall& call) {
  std::vector<Place> places;
  for (const auto& [name, x, y, yaw] : poses) places.push_back({name, {x, y, yaw}});
  std::vector<PythonMap> maps{from};
  if (!areSameArray(from, to)) maps.push_back(to);
  maps.insert(maps.end(), via.begin(), via.end());
  auto solved = solve(maps, std::nullopt, call, via.empty());
  const auto hasMap = [&](const PythonMap& map) { return solved->site.site.placeOf(fileOf(map)); };
  if (!via.empty() && !(hasMap(from) && hasMap(to)))
    solved =
        solve({maps.begin(), maps.end() - std::ptrdiff_t(via.size())}, std::nullopt, call, true);
  const SolvedSite& site = solved->site;
  return carryPlaces(places, site, rejoinPieces(site), placeIn(site.site, from),
                     placeIn(site.site, to), onPythonThreads(call.threads, call.progress));
}

py::tuple tupleOf(const CarriedPlace& place) {
  py::object pose = py::none(), error = py::none();
  if (place.pose) {
    pose = py::make_tuple(place.pose->x, place.pose->y, place.pose->phi);
    error = py::float_(place.error);
  }
  return py::make_tuple(pose, nameOf(place.state), error, place.reason);
}

/** Calls without Python's lock, and makes a Python object of each of what comes back. */
template <class Work, class ToObject>
py::list callUnlocked(const Work& work, const ToObject& toObject) {
  decltype(work()) found;
  {
    const py::gil_scoped_release released;
    found = work();
  }
  py::list list;
  for (const auto& one : found) list.append(toObject(one));
  return list;
}

}  // namespace

void bindSite(py::module_& module) {
  module.def(
      "repair",
      [](const std::vector<PythonMap>& maps, const std::optional<PythonMap>& reference,
         const PythonCall& call) {
        return callUnlocked([&] { return repair(maps, reference, call); }, dictOf);
      },
      py::arg("maps"), py::arg("reference"), py::arg("call"));
  module.def(
      "carry",
      [](const std::vector<NamedPose>& places, const PythonMap& from, const PythonMap& to,
         const std::vector<PythonMap>& via, const PythonCall& call) {
        return callUnlocked([&] { return carry(places, from, to, via, call); }, tupleOf);
      },
      py::arg("places"), py::arg("old"), py::arg("new"), py::arg("via"), py::arg("call"));
}

}  // namespace roomgraph
