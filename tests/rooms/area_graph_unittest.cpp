#include "roomgraph/rooms/area_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "Pose.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph::test {
namespace {

/** Two rooms over a corridor, each with a door of 1 m in a thick wall, and a room without a door.
 */
MapText roomsOnACorridor() {
  return drawn(
      {
          "######################################################",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#........A........##..........B.........##.....C.....#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "#.................##....................##...........#",
          "######....#####################....###################",
          "######....#####################....###################",
          "#....................................................#",
          "#....................................................#",
          "#.............................................D......#",
          "#....................................................#",
          "#....................................................#",
          "######################################################",
      },
      0.2);
}

std::uint16_t labelAt(const Stages& stages, Point p) {
  const GridFrame& frame = stages.grid.frame;
  return stages.areas.labels[frame.index(frame.cellAt(p))];
}

Stages extracted(const MapText& map) { return extract(greyMap(map), optionsOf(map)); }

/** Whether each cell shares a side with others like it, down to one of the `starts`. */
std::vector<bool> reached(const Grid& grid, std::vector<Cell> starts) {
  std::vector<bool> isReached(grid.cells.size());
  const auto visit = [&](Cell c) {
    if (grid.atOrUnknown(c) != State::free || isReached[grid.frame.index(c)]) return;
    isReached[grid.frame.index(c)] = true;
    starts.push_back(c);
  };
  while (!starts.empty()) {
    const Cell c = starts.back();
    starts.pop_back();
    for (const Cell n : {Cell{c.x - 1, c.y}, {c.x + 1, c.y}, {c.x, c.y - 1}, {c.x, c.y + 1}})
      visit(n);
  }
  return isReached;
}

TEST(AreaGraph, roomsComeFirstAndInTheirOrder) {
  const Stages stages = extracted(roomsOnACorridor());
  const AreaGraph& graph = stages.areas;
  ASSERT_EQ(stages.result.rooms.size(), 3u);
  ASSERT_EQ(graph.areas.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(graph.areas[i].room, RoomId(i));
    EXPECT_EQ(graph.areas[i].polygon.outer, stages.result.rooms[i].shape.polygon.outer);
    EXPECT_EQ(graph.areas[i].inscribedRadius, stages.result.rooms[i].shape.inscribedRadius);
  }
  EXPECT_FALSE(graph.areas[3].isRoom());
}

TEST(AreaGraph, eachDoorIsOnePassageWithItsWidthAndMiddle) {
  const MapText map = roomsOnACorridor();
  const Stages stages = extracted(map);
  const AreaGraph& graph = stages.areas;
  ASSERT_EQ(graph.passages.size(), 2u);
  for (const auto& [room, doorX] : {std::pair{'A', 8 * 0.2}, {'B', 33 * 0.2}}) {
    const AreaId area(std::size_t(labelAt(stages, map.names.at(room)) - 1));
    ASSERT_EQ(graph.areas[area.index()].passages.size(), 1u) << room;
    const Passage& passage = graph.passages[graph.areas[area.index()].passages[0].index()];
    EXPECT_EQ(passage.a, area);
    EXPECT_EQ(passage.b, AreaId(3));
    // From the centre of the cell on one side to that on the other.
    EXPECT_NEAR(passage.width, 5 * 0.2, 1e-9);
    EXPECT_NEAR(passage.middle().x, doorX, 1e-9);
    EXPECT_NEAR(passage.middle().y, 7 * 0.2, 0.11);
    // Who leaves the room goes down and has the right side of the picture on the left.
    EXPECT_GT(passage.from.x, passage.to.x);
  }
  EXPECT_EQ(graph.areas[3].passages, (std::vector<PassageId>{PassageId(0), PassageId(1)}));
}

TEST(AreaGraph, passagesEndInCornersOfBothPolygons) {
  for (const std::string& name : mapNames()) {
    const AreaGraph graph = extracted(readMapText(name)).areas;
    for (const Passage& passage : graph.passages)
      for (const AreaId id : {passage.a, passage.b})
        for (const Point end : {passage.from, passage.to}) {
          if (!id) continue;
          const Polygon& polygon = graph.areas[id.index()].polygon;
          bool isFound = std::count(polygon.outer.begin(), polygon.outer.end(), end) > 0;
          for (const Ring& hole : polygon.holes)
            isFound |= std::count(hole.begin(), hole.end(), end) > 0;
          EXPECT_TRUE(isFound) << name;
        }
  }
}

TEST(AreaGraph, areasAndPassagesKnowEachOther) {
  for (const std::string& name : mapNames()) {
    const AreaGraph graph = extracted(readMapText(name)).areas;
    std::size_t mentions = 0;
    for (std::size_t a = 0; a < graph.areas.size(); ++a) {
      const auto& passages = graph.areas[a].passages;
      EXPECT_TRUE(std::is_sorted(passages.begin(), passages.end())) << name;
      for (const PassageId p : passages) {
        const Passage& passage = graph.passages[p.index()];
        EXPECT_TRUE(passage.a == AreaId(a) || passage.b == AreaId(a)) << name;
      }
      mentions += passages.size();
    }
    std::size_t sides = 0;
    for (const Passage& passage : graph.passages) {
      EXPECT_TRUE(passage.a < passage.b) << name;
      sides += passage.b ? 2 : 1;
    }
    EXPECT_EQ(mentions, sides) << name;
  }
}

TEST(AreaGraph, aRoomThatTheGraphDoesNotReachHasNoLabel) {
  const MapText map = roomsOnACorridor();
  ExtractOptions options;
  options.keepComponents.onlyLargest = true;
  const Stages stages = extract(greyMap(map), options);
  EXPECT_EQ(labelAt(stages, map.names.at('C')), 0);
  EXPECT_EQ(labelAt(stages, map.names.at('D')), 3);
  const Stages all = extracted(map);
  EXPECT_EQ(labelAt(all, map.names.at('C')), 3);
  EXPECT_EQ(labelAt(all, map.names.at('D')), 4);
}

TEST(AreaGraph, everyFreeCellWithAWayToTheGraphHasOneLabelAndNoOtherCellHas) {
  for (const char* name : {"rooms_on_a_corridor", "two_doors", "office", "room_with_pillars",
                           "ring_corridor", "two_buildings", "room_like_a_u"}) {
    const MapText map = readMapText(name);
    const Stages stages = extracted(map);
    const GridFrame& frame = stages.grid.frame;
    std::vector<Cell> starts;
    for (const Edge& edge : stages.kept.edges())
      for (const Point p : edge.path.points) starts.push_back(frame.cellAt(p));
    const std::vector<bool> isReached = reached(stages.cleared.grid, starts);
    std::size_t missing = 0, tooMany = 0;
    for (std::size_t i = 0; i < isReached.size(); ++i) {
      missing += isReached[i] && stages.areas.labels[i] == 0;
      tooMany += !isReached[i] && stages.areas.labels[i] != 0;
      EXPECT_LE(stages.areas.labels[i], stages.areas.areas.size());
    }
    EXPECT_EQ(missing, 0u) << name << "\n" << picture(map);
    EXPECT_EQ(tooMany, 0u) << name << "\n" << picture(map);
  }
}

/** Whether the place is in the polygon and not on its line, but for what rounding moves. */
bool isWellInside(const Polygon& polygon, Point p, double margin) {
  for (const Point q :
       {p, p + Point{margin, 0}, p - Point{margin, 0}, p + Point{0, margin}, p - Point{0, margin}})
    if (sideOf(polygon, q) != Side::inside) return false;
  return true;
}

TEST(AreaGraph, labelsAreThoseOfThePolygonsThatHoldTheCells) {
  for (const std::string& name : mapNames()) {
    const Stages stages = extracted(readMapText(name));
    const GridFrame& frame = stages.grid.frame;
    std::size_t wrong = 0;
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        if (stages.cleared.grid.at({x, y}) != State::free) continue;
        const std::uint16_t label = stages.areas.labels[frame.index({x, y})];
        const Point center = frame.center({x, y});
        for (std::size_t a = 0; a < stages.areas.areas.size(); ++a)
          wrong += label != a + 1 &&
                   isWellInside(stages.areas.areas[a].polygon, center, 0.01 * frame.resolution);
      }
    EXPECT_EQ(wrong, 0u) << name;
  }
}

TEST(AreaGraph, cellsOfClutterBelongToTheAreaRoundThem) {
  const MapText map = readMapText("room_with_pillars");
  const Stages stages = extracted(map);
  ASSERT_EQ(stages.areas.areas.size(), 1u);
  ASSERT_EQ(stages.cleared.clutter.size(), 2u);
  EXPECT_TRUE(stages.areas.areas[0].polygon.holes.empty());
  for (const Clutter& piece : stages.cleared.clutter) {
    EXPECT_FALSE(stages.grid.isFree(piece.center));
    EXPECT_EQ(labelAt(stages, piece.center), 1);
  }
}

TEST(AreaGraph, aDoorMayLeadToSpaceThatIsInNoArea) {
  // A corridor, and through a door what a beam has seen of a room.
  const Stages stages = extracted(drawn(
      {
          "????????????.................??????????????",
          "?????????????...............???????????????",
          "??????????????.............????????????????",
          "???????????????...........?????????????????",
          "????????????????.........??????????????????",
          "?????????????????.......???????????????????",
          "##################.....####################",
          "#.........................................#",
          "#.........................................#",
          "#.........................................#",
          "#.........................................#",
          "#.........................................#",
          "#.........................................#",
          "###########################################",
      },
      0.2));
  const AreaGraph& graph = stages.areas;
  ASSERT_EQ(graph.areas.size(), 1u);
  EXPECT_NEAR(graph.areas[0].seen.value(), 1, 0.1);
  ASSERT_EQ(graph.passages.size(), 1u);
  EXPECT_EQ(graph.passages[0].a, AreaId(0));
  EXPECT_FALSE(graph.passages[0].b);
  EXPECT_NEAR(graph.passages[0].width, 1.2, 1e-9);
  EXPECT_NEAR(graph.passages[0].evidence.confidence, (1 - 1 / 3.0) / 2, 1e-9)
      << "it may be a window";
  EXPECT_EQ(graph.areas[0].passages, std::vector<PassageId>{PassageId(0)});
}

TEST(AreaGraph, aMapWithoutAGraphHasNoAreas) {
  for (const char* name : {"all_free", "all_occupied", "all_unknown", "one_free_cell"}) {
    const Stages stages = extracted(readMapText(name));
    EXPECT_TRUE(stages.areas.passages.empty()) << name;
    EXPECT_EQ(stages.areas.labels.size(), stages.grid.cells.size()) << name;
    if (stages.areas.areas.empty()) {
      EXPECT_EQ(std::count(stages.areas.labels.begin(), stages.areas.labels.end(), 0),
                std::ptrdiff_t(stages.areas.labels.size()))
          << name;
    }
  }
}

/** One line per area or passage of `a` that `b` does not have in the other pose. */
std::string differenceOfAreas(const Stages& a, const Stages& b,
                              const std::function<Point(Point)>& aToB) {
  std::string lines;
  for (const Area& area : a.areas.areas) {
    // The label of the place tells which one it should be.
    const Point there = aToB(area.widestPlace);
    const std::uint16_t label = labelAt(b, there);
    if (label == 0) {
      lines += "no area at" + std::to_string(there.x) + "," + std::to_string(there.y) + "\n";
      continue;
    }
    const Area& other = b.areas.areas[label - 1u];
    if (other.isRoom() != area.isRoom() || other.passages.size() != area.passages.size() ||
        std::abs(roomgraph::area(other.polygon) / roomgraph::area(area.polygon) - 1) > 0.1)
      lines += "another area with label " + std::to_string(label) + "\n";
  }
  for (const Passage& passage : a.areas.passages) {
    const auto isSame = [&](const Passage& other) {
      // A door in a thick wall has several openings of the same width.
      return distance(other.middle(), aToB(passage.middle())) < 1.5 * a.grid.frame.resolution &&
             std::abs(other.width - passage.width) < 1e-6;
    };
    if (std::none_of(b.areas.passages.begin(), b.areas.passages.end(), isSame))
      lines += "no passage of " + std::to_string(passage.width) + " m\n";
  }
  return lines;
}

TEST(AreaGraph, aMapInAnotherPoseHasTheSameAreasAndPassages) {
  for (const char* name : {"rooms_on_a_corridor", "two_doors", "touching_doors"}) {
    const MapText map = readMapText(name);
    const Stages reference = extracted(map);
    for (Pose pose : symmetries()) {
      pose.shift = {3, -7};
      const Stages found = extracted(posed(map, pose));
      EXPECT_EQ(found.areas.areas.size(), reference.areas.areas.size()) << name << nameOf(pose);
      EXPECT_EQ(found.areas.passages.size(), reference.areas.passages.size())
          << name << nameOf(pose);
      EXPECT_EQ(differenceOfAreas(reference, found, [&](Point p) { return posed(p, map, pose); }),
                "")
          << name << " " << nameOf(pose);
    }
  }
}

}  // namespace
}  // namespace roomgraph::test
