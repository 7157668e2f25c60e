#include "roomgraph/graph_files/ros_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "TestFolder.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

class RosMapFiles : public testing::Test {
 protected:
  void SetUp() override {
    grid_.frame.width = 3, grid_.frame.height = 2;
    grid_.frame.resolution = 0.1, grid_.frame.origin = {-1.537, 1.0 / 3};
    grid_.cells = {State::free,    State::occupied, State::unknown,
                   State::unknown, State::free,     State::occupied};
  }
  Grid reread(const std::string& picture, const std::string& bytes) const {
    folder_.write(picture, bytes);
    return binarize(loadGrid(folder_.write("map.yaml", rosMapYaml(grid_.frame, picture)), {}), {});
  }
  const TestFolder folder_;
  Grid grid_;
};

TEST_F(RosMapFiles, giveTheSameCellsInTheSamePlace) {
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"a.pgm", mapPgm(grid_)},
                                    {"b \"q\" #.png", mapPng(grid_)}}) {
    const Grid again = reread(name, bytes);
    EXPECT_EQ(again.cells, grid_.cells) << name;
    EXPECT_EQ(again.frame.origin.x, grid_.frame.origin.x);
    EXPECT_NEAR(again.frame.origin.y, grid_.frame.origin.y, 0.5e-6);
    EXPECT_EQ(again.frame.resolution, grid_.frame.resolution);
  }
}

TEST_F(RosMapFiles, sayWhereTheyLieAsAPersonWould) {
  const auto originOf = [&](Point origin) {
    grid_.frame.origin = origin;
    const std::string yaml = rosMapYaml(grid_.frame, "a.pgm");
    EXPECT_EQ(yaml.rfind(std::string(kRosMapMark) + "\nimage: ", 0), 0u) << yaml;
    const auto from = yaml.find("[");
    return yaml.substr(from, yaml.find("]") - from + 1);
  };
  EXPECT_EQ(originOf({-13.5, -52.300000000000004}), "[-13.5, -52.3, 0]");
  EXPECT_EQ(originOf({-1e-17, 0.05 * 3}), "[0, 0.15, 0]");
  EXPECT_EQ(originOf({1.0 / 3, -100000.0000004}), "[0.333333, -100000, 0]");
}

TEST_F(RosMapFiles, lieInAnotherFrameWherePosesSaySo) {
  const Transform2D pose{5, -3, M_PI / 2};
  folder_.write("d.pgm", mapPgm(grid_));
  const Grid turned =
      binarize(loadGrid(folder_.write("d.yaml", rosMapYaml(grid_.frame, "d.pgm", pose)), {}), {});
  ASSERT_EQ(turned.cells.size(), grid_.cells.size());
  for (int y = 0; y < grid_.frame.height; ++y)
    for (int x = 0; x < grid_.frame.width; ++x)
      EXPECT_EQ(turned.at(turned.frame.cellAt(pose(grid_.frame.center({x, y})))), grid_.at({x, y}));
}

TEST_F(RosMapFiles, barePicturesGiveTheSameCells) {
  EXPECT_EQ(binarize(loadGrid(folder_.write("c.png", mapPng(grid_)), {}), {}).cells, grid_.cells);
}

}  // namespace
}  // namespace roomgraph
