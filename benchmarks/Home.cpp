#include "Home.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "FloorPlan.h"
#include "keep_seen.h"
#include "roomgraph/base/Error.h"
#include "roughen_walls.h"

namespace roomgraph {
namespace {

constexpr double kResolution = 0.05;  // of drawn homes [m]
constexpr double kGarden = 3;         // round them [m]
constexpr int kSight = 100;           // of the robot [cells]
constexpr int kStep = 8;              // between two places it looks from [cells]
constexpr int kRobot = 3;             // half of its side [cells]

Box readBox(std::istream& words) {
  Box box;
  words >> box.low.x >> box.low.y >> box.high.x >> box.high.y;
  return box;
}

Home::LabelledRoom& roomNamed(Home& home, const std::string& name) {
  for (Home::LabelledRoom& room : home.rooms)
    if (room.name == name) return room;
  home.rooms.push_back({name, {}, {}});
  return home.rooms.back();
}

/** Whether the line is one of those in Home.h. */
bool readLine(const std::string& line, Home& home) {
  std::istringstream words(line);
  std::string kind, name;
  if (!(words >> kind) || kind[0] == '#') return true;
  if (kind == "map") {
    words >> home.mapFile >> home.resolution;
  } else if (kind == "outline") {
    words >> name;
    Ring& outline = roomNamed(home, name).outline;
    for (Point p; words >> p.x >> p.y;) outline.push_back(p);
    return outline.size() > 2;
  } else if (kind == "room") {
    words >> name;
    roomNamed(home, name).floor.push_back(readBox(words));
  } else if (kind == "door") {
    home.doors.push_back(readBox(words));
  } else if (kind == "window") {
    home.windows.push_back(readBox(words));
  } else if (kind == "thing") {
    home.things.push_back(readBox(words));
  } else {
    return false;
  }
  return bool(words);
}

CellBox cellsOf(const GridFrame& frame, const Box& box) {
  const auto cell = [&](double metres, double origin) {
    return int(std::lround((metres - origin) / frame.resolution));
  };
  return {cell(box.low.x, frame.origin.x), cell(box.low.y, frame.origin.y),
          cell(box.high.x, frame.origin.x), cell(box.high.y, frame.origin.y)};
}

Box bounds(const Home& home) {
  Box all;
  for (const Home::LabelledRoom& room : home.rooms)
    for (const Box& box : room.floor) all.include(box.low), all.include(box.high);
  return all;
}

bool hasSpace(const GreyMap& plan, Cell at) {
  for (int y = at.y - kRobot; y <= at.y + kRobot; ++y)
    for (int x = at.x - kRobot; x <= at.x + kRobot; ++x)
      if (!plan.frame.contains({x, y}) || plan.grey[plan.frame.index({x, y})] != grey::kFree)
        return false;
  return true;
}

/** All places of a lattice that the robot gets to from the free place nearest to `start`. */
std::vector<Point> drivenPlaces(const GreyMap& plan, Point start) {
  const GridFrame& frame = plan.frame;
  const Cell wanted = frame.cellAt(start);
  Cell first = wanted;
  for (int ring = 1; !hasSpace(plan, first) && ring < frame.width; ++ring)
    for (const Cell c : {Cell{wanted.x + ring, wanted.y}, Cell{wanted.x, wanted.y + ring},
                         Cell{wanted.x - ring, wanted.y}, Cell{wanted.x, wanted.y - ring}})
      if (hasSpace(plan, c)) first = c;
  std::vector<char> isSeen(frame.cellCount());
  std::vector<Cell> queue{first};
  std::vector<Point> places;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Cell at = queue[i];
    if (at.x % kStep == 0 && at.y % kStep == 0) places.push_back(frame.center(at));
    for (const Cell c :
         {Cell{at.x + 1, at.y}, Cell{at.x, at.y + 1}, Cell{at.x - 1, at.y}, Cell{at.x, at.y - 1}})
      if (hasSpace(plan, c) && !isSeen[frame.index(c)]) {
        isSeen[frame.index(c)] = 1;
        queue.push_back(c);
      }
  }
  return places;
}

/** Pixels have row 0 at the top. */
bool isIn(const Ring& outline, Cell cell, int height) {
  const Point at{cell.x + 0.5, height - cell.y - 0.5};
  bool isInside = false;
  for (std::size_t i = 0, last = outline.size() - 1; i < outline.size(); last = i++)
    if (rayCrosses(at, outline[i], outline[last])) isInside = !isInside;
  return isInside;
}

}  // namespace

Home readHome(const std::string& file) {
  std::ifstream stream(file);
  Home home;
  home.name = std::filesystem::path(file).stem().string();
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
    if (!readLine(line, home))
      throw DataError(file + ": line " + std::to_string(number) +
                      " is none of those that Home.h names");
  if (home.rooms.empty()) throw DataError(file + ": has no room");
  return home;
}

GreyMap homePlan(const Home& home, bool isFurnished) {
  const Box house = bounds(home).widened(0.1), site = house.widened(kGarden);
  FloorPlan plan(int(std::lround(site.size().x / kResolution)),
                 int(std::lround(site.size().y / kResolution)), kResolution, site.low);
  const GridFrame frame = plan.map().frame;
  const auto fill = [&](const std::vector<Box>& boxes, std::uint8_t level) {
    for (const Box& box : boxes) plan.fill(cellsOf(frame, box), level);
  };
  fill({site}, grey::kFree);
  fill({house}, grey::kWall);
  for (const Home::LabelledRoom& room : home.rooms) fill(room.floor, grey::kFree);
  fill(home.doors, grey::kFree);
  fill(home.windows, grey::kFree);
  if (isFurnished) fill(home.things, grey::kWall);
  return std::move(plan).take();
}

GreyMap robotMap(const Home& home) {
  Home shut = home;
  shut.windows.clear();  // no way out for the robot
  const Box& first = home.rooms.front().floor.front();
  const std::vector<Point> places =
      drivenPlaces(homePlan(shut, true), midpoint(first.low, first.high));
  GreyMap map = homePlan(home, true);
  roughenWalls(map, {});
  return keepSeen(map, places, kSight);
}

LabelMap homeTruth(const Home& home, const GridFrame& frame) {
  LabelMap truth{frame.width, frame.height, std::vector<std::uint32_t>(frame.cellCount()), {}};
  for (std::size_t r = 0; r < home.rooms.size(); ++r) {
    for (const Box& box : home.rooms[r].floor) {
      const CellBox cells = cellsOf(frame, box);
      for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
          truth.label[frame.index({x, y})] = std::uint32_t(r + 1);
    }
    if (home.rooms[r].outline.empty()) continue;
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x)
        if (isIn(home.rooms[r].outline, {x, y}, frame.height))
          truth.label[frame.index({x, y})] = std::uint32_t(r + 1);
  }
  return truth;
}

}  // namespace roomgraph
