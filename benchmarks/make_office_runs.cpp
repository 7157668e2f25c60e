// Writes runs of one artificial office as simplemaps, each with its own way, frame and drift.
#include <cstdio>
#include <string>

#include "Random.h"
#include "drive_office.h"
#include "make_office.h"
#include "run_benchmark.h"
#include "tour.h"
#include "write_map.h"

namespace roomgraph {
namespace {

struct RunsOptions {
  MakeOfficeOptions office{800, 600, 1, false};
  int count = 10;
  std::string folder = ".";
};

void writeRun(const GreyMap& office, int number, const std::string& file) {
  Random random{std::uint32_t(number)};
  DriveOfficeOptions options;
  options.seed = options.drift.seed = std::uint32_t(number);
  options.drift.turnPerMetre = 2e-5 * random.between(-10, 10);
  options.drift.turnNoise = 2e-4 * random.between(0, 10);
  options.turn = 0.001 * random.between(-3141, 3141);
  writeSimplemap(driveOffice(office, tour(office, options.seed), options).frames, file);
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
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::writeRuns(options); });
}
