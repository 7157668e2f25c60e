// Writes an artificial office as a map file.
#include <string>

#include "make_office.h"
#include "run_benchmark.h"
#include "write_map.h"

int main(int argc, char** argv) {
  CLI::App app("Makes an artificial office of any size, the same on every machine.");
  roomgraph::MakeOfficeOptions options;
  std::string gridmap, ros;
  app.add_option("--width", options.width, "columns of 0.05 m")->capture_default_str();
  app.add_option("--height", options.height, "rows of 0.05 m")->capture_default_str();
  app.add_option("--seed", options.seed, "another number gives another office")
      ->capture_default_str();
  app.add_flag("--plain", options.isPlain, "neither furniture nor noise at the walls");
  app.add_option("-o,--output", gridmap, "the MRPT map to write, NAME.gridmap.gz");
  app.add_option("--ros", ros, "write NAME.png and NAME.yaml");
  return roomgraph::runBenchmark(app, argc, argv, [&] {
    const roomgraph::GreyMap map = roomgraph::makeOffice(options);
    if (!gridmap.empty()) roomgraph::writeGridmap(map, gridmap);
    if (!ros.empty()) roomgraph::writeRosMap(map, ros);
  });
}
