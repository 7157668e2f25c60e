// Every drawing under tests/maps, in all of its poses.
#include <gtest/gtest.h>

#include "Pose.h"
#include "brute_force.h"
#include "roomgraph/pipeline/extract.h"
#include "same_graph.h"
#include "summary.h"

namespace roomgraph::test {
namespace {

/** How rooms are found. */
enum class Way { disc, doors };

using Drawing = std::pair<std::string, Way>;

class Drawings : public testing::TestWithParam<Drawing> {
 protected:
  Drawings() {
    if (way_ == Way::doors || map_.preset != "default") return;
    options_.findRooms.minWidth = 1.6;
    options_.clearClutter.maxSize = 0;
  }

  Stages extractPosed(const Pose& pose) const {
    return extract(greyMap(posed(map_, pose)), options_);
  }

  MapText map_ = readMapText(GetParam().first);
  Way way_ = GetParam().second;
  ExtractOptions options_ = optionsOf(map_);
};

/** Those whose graph is known not to differ from what a person expects. */
class ExpectedDrawings : public Drawings {};

TEST_P(ExpectedDrawings, giveTheGraphThatAPersonExpects) {
  EXPECT_EQ(differenceFromExpected(extract(greyMap(map_), options_), map_), "")
      << map_.sentence << "\n"
      << picture(map_);
}

/** Those whose graph is known not to depend on their pose. */
class SteadyDrawings : public Drawings {};

TEST_P(SteadyDrawings, giveTheSameGraphInEveryPose) {
  const RoomGraph reference = extract(greyMap(map_), options_).result;
  for (const Pose& pose : allPoses(map_)) {
    const RoomGraph found = extractPosed(pose).result;
    // Half a cell for the walls, half for the centres of cells, and what joining may choose.
    const double tolerance = 1.5 * map_.resolution + options_.joinVertices.maxDistance;
    EXPECT_EQ(differenceOfGraphs(
                  reference, found, [&](Point p) { return posed(p, map_, pose); }, tolerance),
              "")
        << nameOf(pose);
  }
}

TEST_P(Drawings, keepTheirPromisesInEveryPose) {
  for (const Pose& pose : allPoses(map_)) {
    const auto broken = brokenPromises(extractPosed(pose));
    EXPECT_TRUE(broken.empty()) << nameOf(pose) << ": " << broken.front();
  }
}

/** Those without an outside and half-seen space, which are left out on purpose. */
class EnclosedDrawings : public Drawings {};

TEST_P(EnclosedDrawings, keepConnectedWhatADiscCanTravel) {
  const auto lost = lostConnections(extract(greyMap(map_), options_), 4);
  EXPECT_TRUE(lost.empty()) << lost.front();
}

bool isAny(const MapText&, Way) { return true; }

const std::string& differs(const MapText& map, Way way) {
  return way == Way::disc ? map.differsByDisc : map.differsByDoors;
}

bool isAsExpected(const MapText& map, Way way) { return differs(map, way).empty(); }

bool isSteady(const MapText& map, Way way) {
  return differs(map, way).find("pose") == std::string::npos;
}

bool isEnclosed(const MapText& map, Way way) {
  if (way == Way::doors && map.expected.noteCodes.count("half_seen")) return false;
  return map.cells.size() == 1 || map.cells.front() != '.' || hasUnknown(map);
}

std::vector<Drawing> drawingsWhere(bool (*applies)(const MapText&, Way)) {
  std::vector<Drawing> drawings;
  for (const std::string& name : mapNames())
    for (const Way way : {Way::disc, Way::doors})
      if (applies(readMapText(name), way)) drawings.push_back({name, way});
  return drawings;
}

std::string nameOfDrawing(const testing::TestParamInfo<Drawing>& drawing) {
  return drawing.param.first + (drawing.param.second == Way::disc ? "_by_disc" : "_by_doors");
}

INSTANTIATE_TEST_SUITE_P(Maps, Drawings, testing::ValuesIn(drawingsWhere(isAny)), nameOfDrawing);
INSTANTIATE_TEST_SUITE_P(Maps, ExpectedDrawings, testing::ValuesIn(drawingsWhere(isAsExpected)),
                         nameOfDrawing);
INSTANTIATE_TEST_SUITE_P(Maps, SteadyDrawings, testing::ValuesIn(drawingsWhere(isSteady)),
                         nameOfDrawing);
INSTANTIATE_TEST_SUITE_P(Maps, EnclosedDrawings, testing::ValuesIn(drawingsWhere(isEnclosed)),
                         nameOfDrawing);

}  // namespace
}  // namespace roomgraph::test
