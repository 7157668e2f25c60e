#include "roomgraph/report/evo_files.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/base/zip_archive.h"

namespace roomgraph {
namespace {

bool isTimed(const ComparedRun& run) {
  return allOf(run.path, [](const PathPose& at) { return at.time.has_value(); });
}

/** What evo knows the places of a path by, those whose error is known. */
struct PathErrors {
  std::vector<double> errors, times, fromStart, distances;
};

PathErrors errorsOf(const ComparedRun& run) {
  PathErrors known;
  double driven = 0;
  const bool hasTimes = isTimed(run);
  for (std::size_t i = 0; i < run.path.size(); ++i) {
    const PathPose& at = run.path[i];
    if (i > 0)
      driven += std::hypot(at.pose.x - run.path[i - 1].pose.x, at.pose.y - run.path[i - 1].pose.y);
    if (!at.error) continue;
    known.errors.push_back(*at.error);
    known.distances.push_back(driven);
    if (!hasTimes) continue;
    known.times.push_back(*at.time);
    known.fromStart.push_back(*at.time - *run.path.front().time);
  }
  return known;
}

/** An array of numpy, as in a file of its own (.npy, version 1). */
std::string npyOf(const std::vector<double>& values) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                       std::to_string(values.size()) + ",), }";
  constexpr std::size_t before = 10, alignment = 64;  // of the values, from the start of the file
  header.append(alignment - (before + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string bytes = std::string("\x93NUMPY\1\0", 8);
  bytes += char(header.size() & 0xFFu);
  bytes += char(header.size() >> 8u);
  bytes += header;
  const std::size_t start = bytes.size();
  bytes.resize(start + values.size() * sizeof(double));
  if (!values.empty()) std::memcpy(&bytes[start], values.data(), values.size() * sizeof(double));
  return bytes;
}

/** The figures that evo tells of the errors of a trajectory. */
Json statisticsOf(const std::vector<double>& errors) {
  const auto count = double(errors.size());
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
  double squares = 0, variance = 0;
  for (const double error : errors) {
    squares += error * error;
    variance += (error - mean) * (error - mean) / count;
  }
  return {{"max", *std::max_element(errors.begin(), errors.end())},
          {"mean", mean},
          {"median", median(errors)},
          {"min", *std::min_element(errors.begin(), errors.end())},
          {"rmse", std::sqrt(squares / count)},
          {"sse", squares},
          {"std", std::sqrt(variance)}};
}

}  // namespace

std::string pathTum(const ComparedRun& run) {
  std::string text;
  const bool hasTimes = isTimed(run);
  for (const PathPose& at : run.path)
    text += formatted("%.6f %.4f %.4f 0 0 0 %.9f %.9f\n", hasTimes ? *at.time : double(at.keyFrame),
                      at.pose.x, at.pose.y, std::sin(at.pose.phi / 2), std::cos(at.pose.phi / 2));
  return text;
}

std::string evoResult(const ComparedRun& run, const std::string& name) {
  const PathErrors known = errorsOf(run);
  if (known.errors.empty()) return "";
  const Json info = {{"title", "Path error against the consensus (roomgraph)"},
                     {"ref_name", "consensus"},
                     {"est_name", name + ".tum"},
                     {"label", "path error (m)"}};
  std::vector<std::pair<std::string, std::string>> files{
      {"info.json", info.dump()},
      {"stats.json", statisticsOf(known.errors).dump()},
      {"error_array.npy", npyOf(known.errors)},
      {"distances_from_start.npy", npyOf(known.distances)}};
  if (!known.times.empty()) {
    files.emplace_back("seconds_from_start.npy", npyOf(known.fromStart));
    files.emplace_back("timestamps.npy", npyOf(known.times));
  }
  files.emplace_back(name + ".tum", pathTum(run));
  return zipArchive(files);
}

}  // namespace roomgraph
