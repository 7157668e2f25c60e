// How well the rooms that all runs of a site agree on are those of its plan.
//
// Sites of simulated SLAM runs, each with the labels of its true plan and the true pose of each map
// in it. All runs of a site are compared; the rooms of the site are laid on the plan by the pose of
// the run with the least error. A room of the plan is found where one of the site overlaps it by
// half (intersection over union); one of the site is false where it overlaps none by 0.3. Nothing
// changes from run to run, so a room that one of them has not, though it looked there, or a door
// that it has gained or lost, is a mistake of that run's rooms or of how they were matched.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "roomgraph/grid/polygon_cells.h"
#include "roomgraph/images/read_labels.h"
#include "run_benchmark.h"
#include "simulated_site.h"

namespace roomgraph {
namespace {

constexpr double kCell = 0.05;    // of all plans [m]
constexpr double kLeastRoom = 2;  // of the plan, that counts [m2]
constexpr double kIsFound = 0.5, kIsFalse = 0.3;

struct Count {
  int rooms = 0, found = 0, told = 0, wrong = 0, seen = 0, gone = 0, unvisited = 0;
  int doors = 0, gained = 0, lost = 0;
  double iou = 0;

  void add(const Count& other) {
    rooms += other.rooms, found += other.found, told += other.told, wrong += other.wrong;
    seen += other.seen, gone += other.gone, unvisited += other.unvisited, iou += other.iou;
    doors += other.doors, gained += other.gained, lost += other.lost;
  }
};

/** plan <- site, by the run with the least error. */
Transform2D placeOf(const Comparison& comparison, const SimulatedSite& site) {
  double least = HUGE_VAL;
  Transform2D place;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    for (const ComparedRun& run : comparison.runs)
      if (run.name == site.runs[i].name && site.truth[i] < least)
        least = site.truth[i], place = site.toTruth[i] * run.pose.inverse();
  return place;
}

/** How many cells rooms of the site share with those of the plan; 0 is none. */
struct Overlaps {
  std::vector<std::vector<double>> shared;  // by room of the site, by label
  std::vector<double> told, labelled;

  double iou(std::size_t room, std::size_t label) const {
    const double both = shared[room][label];
    return both / (told[room] + labelled[label] - both);
  }
};

Overlaps overlapsOf(const std::vector<SiteRoom>& rooms, const Transform2D& place,
                    const LabelMap& labels) {
  const GridFrame frame{labels.width, labels.height, kCell, {}};
  const std::size_t count = 1 + *std::max_element(labels.label.begin(), labels.label.end());
  Overlaps overlaps{{}, {}, std::vector<double>(count)};
  for (const std::uint32_t label : labels.label) ++overlaps.labelled[label];
  for (const SiteRoom& room : rooms) {
    Polygon polygon = room.polygon;
    forEachRing(polygon, [&](Ring& ring) {
      for (Point& corner : ring) corner = place(corner);
    });
    overlaps.shared.emplace_back(count);
    for (const Cell c : cellsIn(polygon, frame))
      ++overlaps.shared.back()[labels.label[frame.index(c)]];
    double told = 0;
    for (std::size_t label = 1; label < count; ++label) told += overlaps.shared.back()[label];
    overlaps.told.push_back(told);
  }
  return overlaps;
}

Count countSite(const std::string& folder, const std::vector<SiteRoom>& rooms,
                const Transform2D& place) {
  const Overlaps overlaps = overlapsOf(rooms, place, readLabels(folder + "/truth_labels.png"));
  Count count;
  for (std::size_t label = 1; label < overlaps.labelled.size(); ++label) {
    if (overlaps.labelled[label] * kCell * kCell < kLeastRoom) continue;
    double best = 0;
    for (std::size_t room = 0; room < rooms.size(); ++room)
      best = std::max(best, overlaps.iou(room, label));
    ++count.rooms, count.found += best > kIsFound, count.iou += best;
  }
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    double best = 0;
    for (std::size_t label = 1; label < overlaps.labelled.size(); ++label)
      best = std::max(best, overlaps.iou(room, label));
    if (!rooms[room].isCorridor) ++count.told, count.wrong += best < kIsFalse;
    for (const SiteDoor& door : rooms[room].doors) count.doors += int(door.seenIn.size());
    for (const RoomInRun& run : rooms[room].runs) {
      count.gained += run.doorsGained, count.lost += run.doorsLost;
      count.seen += run.sighting == RoomSighting::seen;
      count.gone += run.sighting == RoomSighting::gone;
      count.unvisited += run.sighting == RoomSighting::unvisited;
    }
  }
  return count;
}

void print(const std::string& name, const Count& count) {
  std::printf("| %s | %d | %d | %.1f | %d | %d |", name.c_str(), count.rooms, count.found,
              100 * count.iou / std::max(1, count.rooms), count.told, count.wrong);
  std::printf(" %d | %d | %d | %d | %d | %d |\n", count.seen, count.gone, count.unvisited,
              count.doors, count.gained, count.lost);
  std::fflush(stdout);
}

void measure(const std::string& data, const std::string& only) {
  std::printf(
      "| site | rooms of the plan | found | mean IoU | rooms told | false | seen in a run | gone | "
      "unvisited | doors in a run | gained | lost |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  Count all;
  for (const std::string& folder : simulatedSites(data, only)) {
    const SimulatedSite site = readSite(folder, ".simplemap.gz");
    const Comparison comparison = compareRuns(site.runs, site.related, {});
    const Count count = countSite(folder, comparison.rooms, placeOf(comparison, site));
    print(site.name, count);
    all.add(count);
  }
  print("**all**", all);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Holds the rooms that the runs of a site agree on against the labels of its plan.");
  std::string data, only;
  roomgraph::declareSites(data, only, app);
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::measure(data, only); });
}
