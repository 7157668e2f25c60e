#include "roomgraph/graph_files/ros_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

class RosMapFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "roomgraph-test-XXXXXX").string();
    ASSERT_TRUE(mkdtemp(name.data()));
    folder_ = name;
    grid_.frame.width = 3, grid_.frame.height = 2;
    grid_.frame.resolution = 0.1, grid_.frame.origin = {-1.537, 1.0 / 3};
    grid_.cells = {State::free,    State::occupied, State::unknown,
                   State::unknown, State::free,     State::occupied};
  }
  void TearDown() override { fs::remove_all(folder_); }
  Grid reread(const std::string& picture, const std::string& bytes) const {
    std::ofstream(folder_ / picture, std::ios::binary) << bytes;
    std::ofstream(folder_ / "map.yaml") << rosMapYaml(grid_.frame, picture);
    return binarize(loadGrid((folder_ / "map.yaml").string(), {}), {});
  }
  fs::path folder_;
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
  std::ofstream(folder_ / "d.pgm", std::ios::binary) << mapPgm(grid_);
  std::ofstream(folder_ / "d.yaml") << rosMapYaml(grid_.frame, "d.pgm", pose);
  const Grid turned = binarize(loadGrid((folder_ / "d.yaml").string(), {}), {});
  ASSERT_EQ(turned.cells.size(), grid_.cells.size());
  for (int y = 0; y < grid_.frame.height; ++y)
    for (int x = 0; x < grid_.frame.width; ++x)
      EXPECT_EQ(turned.at(turned.frame.cellAt(pose(grid_.frame.center({x, y})))), grid_.at({x, y}));
}

TEST_F(RosMapFiles, barePicturesGiveTheSameCells) {
  std::ofstream(folder_ / "c.png", std::ios::binary) << mapPng(grid_);
  EXPECT_EQ(binarize(loadGrid((folder_ / "c.png").string(), {}), {}).cells, grid_.cells);
}

}  // namespace
}  // namespace roomgraph
