// Makes the samples of share/roomgraph/maps: make_sample_maps DIRECTORY
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "FloorPlan.h"
#include "keep_seen.h"
#include "roomgraph/base/Error.h"
#include "roughen_walls.h"
#include "sample_office.h"
#include "simulate_scans.h"
#include "walk.h"
#include "write_map.h"

namespace roomgraph {
namespace {

constexpr int kKeyFrames = 80;
constexpr int kPlaces = 600;  // that the map is seen from
constexpr int kSight = 300;   // [cells]

std::vector<Point> placesOf(const std::vector<WalkPose>& poses) {
  std::vector<Point> places;
  for (const WalkPose& pose : poses) places.push_back(pose.at);
  return places;
}

void checkTour(const GreyMap& map, const std::vector<Point>& places) {
  for (const Point& p : places)
    if (map.grey[map.frame.index(map.frame.cellAt(p))] != grey::kFree)
      throw DataError("the tour hits something at (" + std::to_string(p.x) + ", " +
                      std::to_string(p.y) + ")");
}

void writeSimplemap(const mrpt::maps::CSimpleMap& frames, const std::string& file) {
  mrpt::io::CFileGZOutputStream out;
  if (!out.open(file, 9)) throw DataError(file + ": cannot be written; check the directory");
  mrpt::serialization::archiveFrom(out) << frames;
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
                 directory + "/office.simplemap.gz");
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_sample_maps DIRECTORY\n");
    return 2;
  }
  try {
    roomgraph::makeAll(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_sample_maps: %s\n", error.what());
    return 1;
  }
  return 0;
}
