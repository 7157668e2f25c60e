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

class Drawings : public testing::TestWithParam<std::tuple<std::string, Way>> {
 protected:
  Drawings() {
    if (way_ == Way::doors || map_.preset != "default") return;
    options_.findRooms.minWidth = 1.6;
    options_.clearClutter.maxSize = 0;
  }

  Stages extractPosed(const Pose& pose) const {
    return extract(greyMap(posed(map_, pose)), options_);
  }

  MapText map_ = readMapText(std::get<0>(GetParam()));
  Way way_ = std::get<1>(GetParam());
  ExtractOptions options_ = optionsOf(map_);
};

TEST_P(Drawings, giveTheGraphThatAPersonExpects) {
  if (way_ == Way::doors && !map_.differsByDoors.empty())
    GTEST_SKIP() << "known to differ: " << map_.differsByDoors;
  EXPECT_EQ(differenceFromExpected(extract(greyMap(map_), options_), map_), "")
      << map_.sentence << "\n"
      << picture(map_);
}

TEST_P(Drawings, giveTheSameGraphInEveryPose) {
  if (way_ == Way::doors && map_.differsByDoors.find("pose") != std::string::npos)
    GTEST_SKIP() << "known to differ: " << map_.differsByDoors;
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

TEST_P(Drawings, keepConnectedWhatADiscCanTravel) {
  if (map_.cells.size() > 1 && map_.cells.front() == '.' && !hasUnknown(map_))
    GTEST_SKIP() << "what lies outside of the building is left out on purpose";
  const auto lost = lostConnections(extract(greyMap(map_), options_), 4);
  EXPECT_TRUE(lost.empty()) << lost.front();
}

INSTANTIATE_TEST_SUITE_P(Maps, Drawings,
                         testing::Combine(testing::ValuesIn(mapNames()),
                                          testing::Values(Way::disc, Way::doors)),
                         [](const auto& drawing) {
                           const bool isDisc = std::get<1>(drawing.param) == Way::disc;
                           return std::get<0>(drawing.param) + (isDisc ? "_by_disc" : "_by_doors");
                         });

}  // namespace
}  // namespace roomgraph::test
