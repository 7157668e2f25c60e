#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "TestFolder.h"
#include "drawn_cloud.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "sampled_grid.h"

namespace roomgraph::test {

/** Simplemaps with a cloud of a room of 4 m with a table, seen from a tilted sensor, in a folder of
 *  their own. */
class Clouds : public testing::Test {
 protected:
  GreyMap load(const std::string& bytes, const LoadGridOptions& options = {}) const {
    return loadGrid(dir_.write("run.simplemap", bytes), options);
  }
  std::string errorOf(const std::string& bytes) const {
    return test::refusalOf([&] { load(bytes); });
  }
  /** The four walls of the room are in the map, within a cell, and little else. */
  static void expectRoom(const GreyMap& map) {
    const Grid grid = binarize(map, {});
    int walls = 0, strays = 0;
    for (const Point p : occupiedPlaces(grid)) {
      const bool isWall = std::abs(std::max(std::abs(p.x), std::abs(p.y)) - 2) < 0.08;
      ++(isWall ? walls : strays);
    }
    EXPECT_GT(walls, 250);
    EXPECT_LT(strays, walls / 20);
    EXPECT_TRUE(grid.isFree({0.5, 0.4}));
    ASSERT_FALSE(map.notes.empty());
    EXPECT_EQ(map.notes[0].code, "slice");
  }
  std::string inside(const std::string& pointsMap) const {
    return oneObservation(cloudBytes(sensor_, std::string(1, '\0') + pointsMap));
  }
  std::string outside(char storage, const std::string& file) const {
    return oneObservation(
        cloudBytes(sensor_, std::string(1, storage) + raw(std::uint32_t(file.size())) + file));
  }
  void writeBeside(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(dir_ / "run_Images");
    dir_.write("run_Images/" + name, bytes);
  }

  const TestFolder dir_;
  const mrpt::poses::CPose3D sensor_{0.3, -0.2, 0.5, 0.7, 0.05, -0.02};
  const Points points_ = seenFrom(sensor_, roomPoints());
  const std::string simple_ =
      pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, points_, std::string(30, '\x88'));
};

}  // namespace roomgraph::test
