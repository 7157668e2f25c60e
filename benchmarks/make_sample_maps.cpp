#include <cstdio>
#include <string>
#include <vector>

#include "FloorPlan.h"
#include "keep_seen.h"
#include "map_error.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roughen_walls.h"
#include "run_benchmark.h"
#include "sample_office.h"
#include "sample_runs.h"
#include "simulate_scans.h"
#include "walk.h"
#include "write_map.h"

namespace roomgraph {
namespace {

constexpr int kKeyFrames = 80;
constexpr int kPlaces = 600;  // that the map is seen from
constexpr int kBeamsOfRuns = 271;
constexpr int kSight = 300;  // [cells]

std::vector<Point> placesOf(const std::vector<WalkPose>& poses) {
  std::vector<Point> places;
  for (const WalkPose& pose : poses) places.push_back(pose.place);
  return places;
}

void checkTour(const GreyMap& map, const std::vector<Point>& places) {
  for (const Point& p : places)
    if (map.grey[map.frame.index(map.frame.cellAt(p))] != grey::kFree)
      throw DataError("the tour hits something at (" + std::to_string(p.x) + ", " +
                      std::to_string(p.y) + ")");
}

std::string decimals(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/** What is true of a run: its frame in the office's, its error, its break. */
std::string truthLine(const SampleRun& run, double mapError) {
  const WalkPose& first = run.truth.front();
  const Transform2D frame =
      Transform2D{first.place.x, first.place.y, first.heading} * run.believed.front().inverse();
  std::string line = run.name + "," + decimals(frame.x, 3) + "," + decimals(frame.y, 3) + "," +
                     decimals(frame.phi, 4) + "," + decimals(mapError, 2);
  if (!run.breakAt) return line + ",,,\n";
  const Point at = run.truth[*run.breakAt].place;
  return line + "," + decimals(at.x, 2) + "," + decimals(at.y, 2) + "," +
         decimals(run.breakTurn * 180 / M_PI, 1) + "\n";
}

void makeRuns(const SampleOffice& office, const std::string& directory) {
  std::string truth = "run,x,y,phi,map_error_m,break_x,break_y,break_deg\n";
  std::uint32_t seed = 11;
  for (const SampleRun& run : sampleRuns(office)) {
    checkTour(office.map, placesOf(run.truth));
    SimulateScansOptions laser;
    laser.beams = kBeamsOfRuns;
    laser.seed = seed++;
    const auto frames = simulateScans(office.map, run.truth, run.believed, laser);
    writeSimplemap(frames, directory + "/" + run.name + ".simplemap.gz", 9);
    truth += truthLine(run, mapError(frames, run.truth));
  }
  writeFileAtomically(directory + "/office_runs.csv", truth);
}

void makeAll(const std::string& directory) {
  const SampleOffice office = sampleOffice();
  const auto places = placesOf(walk(office.tour, kPlaces));
  checkTour(office.map, places);
  GreyMap rough = office.map;
  roughenWalls(rough, {30, 30, 7});
  const GreyMap seen = keepSeen(rough, places, kSight);
  writeGridmap(seen, directory + "/office.gridmap.gz");
  writeRosMap(seen, directory + "/office");
  writeSimplemap(simulateScans(office.map, walk(office.tour, kKeyFrames), {}),
                 directory + "/office.simplemap.gz", 9);
  makeRuns(office, directory);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Makes the samples of share/roomgraph/maps, the same bytes each time.");
  std::string directory;
  app.add_option("DIRECTORY", directory, "share/roomgraph/maps")->required();
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::makeAll(directory); });
}
