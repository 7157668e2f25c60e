// How many rooms of homes are found, and how many of the rooms that are found are none.
//
// Homes that are drawn as text (benchmarks/homes) are taken three times: empty, furnished, and as a
// cleaning robot would have mapped them. Real ones (with --data) have labels by hand. A room is
// found where its intersection over union with a room of ours is more than a half; one that its
// name calls a hall or corridor may be a corridor of ours. False is a room of ours without partner.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "Home.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"
#include "run_benchmark.h"
#include "write_map.h"

namespace roomgraph {
namespace {

constexpr double kLeastFound = 85, kMostFalse = 10;  // [%]

struct Found {
  std::size_t truths = 0, found = 0, rooms = 0, falseRooms = 0;

  Found& operator+=(const Found& other) {
    truths += other.truths, found += other.found;
    rooms += other.rooms, falseRooms += other.falseRooms;
    return *this;
  }
  double foundPercent() const { return truths ? 100.0 * double(found) / double(truths) : 0; }
  double falsePercent() const { return rooms ? 100.0 * double(falseRooms) / double(rooms) : 0; }
};

bool mayBeCorridor(const std::string& name) {
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return has("hall") || has("corridor") || has("passage") || has("landing") || has("entrance");
}

Found score(const Home& home, const GreyMap& map, bool isVerbose) {
  const Stages stages = extract(map, {});
  const LabelMap truth = homeTruth(home, map.frame);
  std::vector<std::size_t> ofTruth(home.rooms.size() + 1), ofArea(stages.areas.areas.size() + 1);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> both;
  for (std::size_t i = 0; i < truth.label.size(); ++i) {
    if (stages.cleared.grid.cells[i] != State::free) continue;
    ++ofTruth[truth.label[i]], ++ofArea[stages.areas.labels[i]];
    ++both[{truth.label[i], stages.areas.labels[i]}];
  }
  Found found{home.rooms.size(), 0, stages.result.rooms.size(), stages.result.rooms.size()};
  std::vector<bool> isFound(home.rooms.size() + 1);
  for (const auto& [pair, cells] : both) {
    const auto [room, area] = pair;
    if (room == 0 || area == 0 || 2 * cells * 1.5 <= double(ofTruth[room] + ofArea[area])) continue;
    const bool isRoom = stages.areas.areas[area - 1].isRoom();
    if (isRoom) --found.falseRooms;
    isFound[room] = isRoom || mayBeCorridor(home.rooms[room - 1].name);
  }
  found.found = std::size_t(std::count(isFound.begin(), isFound.end(), true));
  for (std::size_t r = 0; isVerbose && r < home.rooms.size(); ++r)
    if (!isFound[r + 1])
      std::fprintf(stderr, "  %s: %s is missed\n", home.name.c_str(), home.rooms[r].name.c_str());
  return found;
}

void printRow(const std::string& home, const std::string& what, const Found& found) {
  std::printf("| %s | %s | %zu | %zu | %.0f | %zu | %.0f |\n", home.c_str(), what.c_str(),
              found.truths, found.found, found.foundPercent(), found.falseRooms,
              found.falsePercent());
}

std::vector<std::string> homeFiles(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".home") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

/** The forms of a home that there are, with what they are called. */
std::vector<std::pair<std::string, GreyMap>> mapsOf(const Home& home, const std::string& data) {
  if (home.mapFile.empty())
    return {{"empty", homePlan(home, false)},
            {"furnished", homePlan(home, true)},
            {"robot", robotMap(home)}};
  if (data.empty()) return {};
  LoadGridOptions options;
  options.resolution = home.resolution;
  return {{"real", loadGrid((std::filesystem::path(data) / home.mapFile).string(), options)}};
}

bool measure(const std::string& homes, const std::string& data, const std::string& mapFolder,
             bool isVerbose) {
  std::map<std::string, Found> sums;
  Found all;
  std::printf("| home | map | rooms | found | %% | false | %% |\n|---|---|---|---|---|---|---|\n");
  for (const std::string& file : homeFiles(homes)) {
    const Home home = readHome(file);
    for (const auto& [what, map] : mapsOf(home, data)) {
      const Found found = score(home, map, isVerbose);
      printRow(home.name, what, found);
      sums[what] += found, all += found;
      if (!mapFolder.empty())
        writeGridmap(map, mapFolder + "/" + home.name + "_" + what + ".gridmap.gz");
    }
  }
  for (const auto& [what, found] : sums) printRow("**all**", what, found);
  printRow("**all**", "", all);
  return all.foundPercent() >= kLeastFound && all.falsePercent() <= kMostFalse;
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Counts the rooms of homes that are found; exit code 1 where a target is missed.");
  std::string homes, data, maps;
  bool isVerbose = false;
  app.add_option("HOMES", homes, "folder of the homes, benchmarks/homes")->required();
  app.add_option("--data", data, "folder of the map data, for the real homes");
  app.add_option("--maps", maps, "also write each map into this folder");
  app.add_flag("--rooms", isVerbose, "also list the rooms that are missed, on standard error");
  return roomgraph::runBenchmark(app, argc, argv,
                                 [&] { return roomgraph::measure(homes, data, maps, isVerbose); });
}
