#include "sample_view.h"

#include "MapText.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph::test {
namespace {

const std::vector<std::string> kTwoRooms = {"###############", "#......#......#", "#......#......#",
                                            "#......#......#", "#.............#", "#......#......#",
                                            "#......#......#", "###############"};

}  // namespace

View sampleView() {
  View view;
  view.comparison.runs.resize(2);
  view.comparison.runs[0].name = "good", view.comparison.runs[1].name = "torn";
  for (std::size_t r = 0; r < 2; ++r) {
    view.runs.emplace_back();
    view.runs[r].name = view.comparison.runs[r].name;
    for (std::size_t k = 0; k < (r == 0 ? 5u : 30u); ++k) {
      const Transform2D pose{0.5 * double(k), double(r), 0};
      view.comparison.runs[r].path.push_back({k, 1e9 + double(k), pose, 0.1 * double(r)});
      view.runs[r].scans.emplace_back();
      view.runs[r].scans.back().keyFrame = k;
      view.runs[r].scans.back().pose = pose;
      view.runs[r].scans.back().walls = {{{pose.x, pose.y + 1}, {0, -1}}};
    }
  }
  view.comparison.breaks = {{"torn", {6, 1}, 0.2, 1, 12, 1e9, TornPose{{6, 1, 0}, {5, 1, -0.2}}},
                            {"good", {1, 0}, 0.1, 0.5, {}, {}, {}}};
  view.faults = faultsOf(view.comparison);
  SiteRoom room;
  room.id = room.name = "R1", room.area = 200;
  room.polygon.outer = {{-1, -5}, {19, -5}, {19, 5}, {-1, 5}};
  room.runs.resize(2);
  room.runs[0].run = "good", room.runs[0].sighting = RoomSighting::seen;
  room.runs[1].run = "torn", room.runs[1].sighting = RoomSighting::gone;
  view.comparison.rooms = {room};
  return view;
}

View viewWithMaps() {
  View view = sampleView();
  const auto map = wallMap(gridOf(drawn(kTwoRooms, 0.5)));
  for (Run& run : view.runs) run.map = map;
  return view;
}

View viewOfMap() {
  View view;
  view.comparison.runs.resize(1);
  view.map = greyMap(drawn(kTwoRooms, 0.5));
  extractAgain(view);
  return view;
}

}  // namespace roomgraph::test
