// Writes runs of one artificial office as simplemaps, each with its own way, frame and drift.
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "Random.h"
#include "drift.h"
#include "make_office.h"
#include "roomgraph/base/Error.h"
#include "simulate_scans.h"
#include "tour.h"

namespace roomgraph {
namespace {

constexpr double kMetresPerFrame = 2;

struct RunsOptions {
  MakeOfficeOptions office{800, 600, 1, false};
  int count = 10;
  std::string folder = ".";
};

double lengthOf(const std::vector<Point>& corners) {
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += distance(corners[i - 1], corners[i]);
  return length;
}

void writeRun(const GreyMap& office, int number, const std::string& file) {
  const auto seed = std::uint32_t(number);
  const std::vector<Point> corners = tour(office, seed);
  if (corners.size() < 2) throw UsageError("this office has no room for a robot: use another one");
  const auto truth = walk(corners, std::max(2, int(lengthOf(corners) / kMetresPerFrame)));
  Random random(seed);
  DriftOptions errors;
  errors.turnPerMetre = 2e-5 * random.between(-10, 10);
  errors.turnNoise = 2e-4 * random.between(0, 10);
  errors.seed = seed;
  SimulateScansOptions laser;
  laser.seed = seed;
  const double turn = 0.001 * random.between(-3141, 3141);
  const auto frames = simulateScans(office, truth, drift(truth, {0, 0, turn}, errors), laser);
  mrpt::io::CFileGZOutputStream out;
  if (!out.open(file, 1)) throw DataError(file + ": cannot be written; check the directory");
  mrpt::serialization::archiveFrom(out) << frames;
}

void writeRuns(const RunsOptions& options) {
  const GreyMap office = makeOffice(options.office);
  for (int i = 1; i <= options.count; ++i) {
    char name[20];
    std::snprintf(name, sizeof name, "/run%02d", i);
    writeRun(office, i, options.folder + name + ".simplemap.gz");
  }
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Makes runs of one artificial office, the same on every machine.");
  roomgraph::RunsOptions options;
  app.add_option("--width", options.office.width, "columns of 0.05 m")->capture_default_str();
  app.add_option("--height", options.office.height, "rows of 0.05 m")->capture_default_str();
  app.add_option("--seed", options.office.seed, "another number gives another office")
      ->capture_default_str();
  app.add_option("--count", options.count, "runs")->capture_default_str();
  app.add_option("-o,--output", options.folder, "folder for runNN.simplemap.gz, which must exist")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    roomgraph::writeRuns(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_office_runs: %s\n", error.what());
    return 1;
  }
  return 0;
}
