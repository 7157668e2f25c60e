// How many rooms change when a map is turned, or drawn with larger or smaller cells.
//
// The thresholded map is resampled with 3 x 3 samples per cell (turn_map.h says how, and why walls
// of one cell survive), goes through the extraction with the defaults, and the rooms are laid back
// on the map as it was. A room is found again where its intersection over union with a room of the
// turned map is more than a half. Changed are the rooms that are lost and the new ones without
// partner, as a share of the rooms of the map. The same defaults for all maps.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "floor_plans.h"
#include "room_rules.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/measures/match_elements.h"
#include "roomgraph/pipeline/extract.h"
#include "run_benchmark.h"
#include "turn_map.h"
#include "write_map.h"

namespace roomgraph {
namespace {

constexpr double kMostChanged = 0.05;
constexpr double kFiner[] = {0.5, 0.71, 1.41, 2};

struct Case {
  std::string name;
  std::function<GreyMap()> load;
};

struct Change {
  std::size_t base = 0, lost = 0, added = 0;  ///< rooms, over all poses

  double share(std::size_t rooms) const {
    return base ? double(rooms) / double(base) : rooms ? 1 : 0;
  }
  double changed() const { return share(lost + added); }
  Change& operator+=(const Change& other) {
    base += other.base, lost += other.lost, added += other.added;
    return *this;
  }
};

struct CaseChanges {
  std::size_t rooms = 0;
  Change quarters, turned;  ///< by multiples of 90 degrees, which moves cells only; by others
  Change finer[std::size(kFiner)];
  int worstDegrees = 0;
  Change worst;  ///< at that angle

  CaseChanges& operator+=(const CaseChanges& other) {
    rooms += other.rooms, quarters += other.quarters, turned += other.turned;
    for (std::size_t i = 0; i < std::size(kFiner); ++i) finer[i] += other.finer[i];
    return *this;
  }
  Change byAngle() const { return Change(quarters) += turned; }
  Change byResolution() const {
    Change sum;
    for (const Change& change : finer) sum += change;
    return sum;
  }
};

std::vector<Case> allCases(const std::string& data) {
  std::vector<Case> cases;
  for (const std::string& name : floorPlanNames(data))
    cases.push_back(
        {name, [=] { return floorPlan(data, name, "", floorPlanTruth(data, name).width); }});
  for (const char* file :
       {"paper_maps/belgioioso/belgioioso_render.yaml", "paper_maps/edmonton/edmonton_render.yaml",
        "paper_maps/longwood/longwood.yaml", "multi_run/strands_tsc/tsc_2016-05.yaml"}) {
    const std::filesystem::path path = std::filesystem::path(data) / file;
    cases.push_back({path.stem().string(), [=] { return loadGrid(path.string(), {}); }});
  }
  return cases;
}

std::vector<GraphRoom> laidBack(std::vector<GraphRoom> rooms, const MapPose& pose,
                                const GridFrame& old) {
  const auto layBack = [&](Ring& ring) {
    for (Point& p : ring) p = turnedBack(p, pose, old);
  };
  for (GraphRoom& room : rooms) {
    room.shape.widestPlace = turnedBack(room.shape.widestPlace, pose, old);
    layBack(room.shape.polygon.outer);
    for (Ring& hole : room.shape.polygon.holes) layBack(hole);
  }
  return rooms;
}

/** Where to find a room on the map, for people. */
void printRoom(const char* what, const GraphRoom& room) {
  std::fprintf(stderr, "  %s %.1f m2 at %.1f %.1f, width %.2f m\n", what, area(room.shape.polygon),
               room.shape.widestPlace.x, room.shape.widestPlace.y, 2 * room.shape.inscribedRadius);
}

void printUnmatched(const char* what, const std::vector<GraphRoom>& rooms,
                    const std::vector<bool>& isMatched) {
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (!isMatched[i]) printRoom(what, rooms[i]);
}

struct Request {
  std::string data, only, maps;
  int step = 10, until = 360;
  bool isVerbose = false;
};

Change changeAt(const Stages& base, const ExtractOptions& options, const MapPose& pose,
                const Request& request) {
  const std::vector<GraphRoom>& rooms = base.result.rooms;
  const GridFrame& frame = base.grid.frame;
  const GreyMap turned = turnMap(base.grid, pose);
  if (!request.maps.empty())
    writeGridmap(turned, request.maps + "/" + request.only + "_" +
                             std::to_string(std::lround(pose.angle * 180 / M_PI)) + "_" +
                             std::to_string(std::lround(100 * pose.finer)) + ".gridmap.gz");
  const std::vector<GraphRoom> others =
      laidBack(extract(turned, options).result.rooms, pose, frame);
  const std::vector<MatchedRooms> matched = matchRooms(rooms, others, frame);
  if (request.isVerbose) {
    std::vector<bool> isFound(rooms.size()), hasPartner(others.size());
    for (const MatchedRooms& pair : matched)
      isFound[pair.base.index()] = hasPartner[pair.other.index()] = true;
    std::fprintf(stderr, "%.0f degrees, cells %.2f times smaller:\n", pose.angle * 180 / M_PI,
                 pose.finer);
    printUnmatched("lost", rooms, isFound);
    printUnmatched("new ", others, hasPartner);
  }
  return {rooms.size(), rooms.size() - matched.size(), others.size() - matched.size()};
}

CaseChanges measure(const Case& which, const ExtractOptions& options, const Request& request) {
  const Stages base = extract(which.load(), options);
  CaseChanges changes;
  changes.rooms = base.result.rooms.size();
  for (int degrees = 0; degrees < request.until; degrees += request.step) {
    const Change change = changeAt(base, options, {degrees * M_PI / 180, 1}, request);
    (degrees % 90 == 0 ? changes.quarters : changes.turned) += change;
    if (change.changed() > changes.worst.changed())
      changes.worst = change, changes.worstDegrees = degrees;
  }
  for (std::size_t i = 0; i < std::size(kFiner); ++i)
    changes.finer[i] = changeAt(base, options, {0, kFiner[i]}, request);
  return changes;
}

const char* verdict(bool isWithin) { return isWithin ? "PASS" : "**over**"; }

bool printRow(const std::string& name, const CaseChanges& changes) {
  std::printf("| %s | %zu | %.1f | %.1f | %.1f | %.1f |", name.c_str(), changes.rooms,
              100 * changes.quarters.changed(), 100 * changes.turned.share(changes.turned.lost),
              100 * changes.turned.share(changes.turned.added), 100 * changes.turned.changed());
  if (changes.worst.base)
    std::printf(" %.1f at %d° |", 100 * changes.worst.changed(), changes.worstDegrees);
  else
    std::printf(" |");
  for (const Change& change : changes.finer) std::printf(" %.1f |", 100 * change.changed());
  const bool isTurnable = changes.byAngle().changed() < kMostChanged;
  const bool isScalable = changes.byResolution().changed() < kMostChanged;
  std::printf(" %s | %s |\n", verdict(isTurnable), verdict(isScalable));
  std::fflush(stdout);
  return isTurnable && isScalable;
}

void printHeader() {
  std::printf(
      "Rooms that change, in %% of the rooms of the map:\n\n"
      "| map | rooms | quarter turns | other angles: lost | new | changed | worst angle |");
  for (const double finer : kFiner) std::printf(" resolution ×%g |", finer);
  std::printf(" turned < %g | resolution < %g |\n|---|---|---|---|---|---|---|", 100 * kMostChanged,
              100 * kMostChanged);
  for (std::size_t i = 0; i < std::size(kFiner) + 2; ++i) std::printf("---|");
  std::printf("\n");
}

/** Over all maps. Prints a row for each map as well where `isEach`. */
CaseChanges measureMaps(const Request& request, const RoomRule& rule, bool isEach) {
  CaseChanges all;
  Request quiet = request;
  quiet.isVerbose = false, quiet.maps.clear();
  for (const Case& which : allCases(request.data)) {
    if (!request.only.empty() && request.only != which.name) continue;
    const CaseChanges changes = measure(which, rule.options, isEach ? request : quiet);
    if (isEach) printRow(which.name, changes);
    all += changes;
  }
  if (all.rooms == 0) throw UsageError("there is no map '" + request.only + "' with rooms");
  return all;
}

/** The targets are for the rooms of all maps together, with the default rule. */
bool measureAll(const Request& request) {
  printHeader();
  const RoomRule rule = defaultRule();
  const bool isWithin = printRow("**all rooms**", measureMaps(request, rule, true));
  if (!request.only.empty()) return isWithin;
  for (const RoomRule& ablated : ablatedRules())
    printRow("ablation: " + ablated.name, measureMaps(request, ablated, false));
  return isWithin;
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app(
      "Turns maps and changes their resolution, and counts the rooms that change; exit code 1 "
      "where these are 5 % or more.");
  roomgraph::Request request;
  app.add_option("--data", request.data,
                 "folder of the map data; it holds room_seg/ipa and paper_maps")
      ->required();
  app.add_option("--only", request.only, "only this map, as lab_a_scan or longwood");
  app.add_option("--step", request.step, "between two angles [degrees]")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  app.add_option("--until", request.until,
                 "angles below this only; as quarter turns change nothing, 90 is as good as 360")
      ->check(CLI::Range(1, 360))
      ->capture_default_str();
  app.add_flag("--rooms", request.isVerbose,
               "also list the lost and the new rooms, on standard error");
  app.add_option("--maps", request.maps, "also write each turned map into this folder");
  return roomgraph::runBenchmark(app, argc, argv, [&] { return roomgraph::measureAll(request); });
}
