#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include "TestFolder.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"

namespace roomgraph {
namespace {

TEST(GridmapFile, givesTheSameCellsInTheSamePlaceToUsAndToMrpt) {
  GreyMap map;
  map.frame.width = 5, map.frame.height = 2;
  map.frame.resolution = 0.1, map.frame.origin = {-1.5, 0.625};
  map.grey = {0, 40, 89, 130, 200, 205, 210, 254, 255, 128};
  map.occupiedAbove = 0.65, map.freeBelow = 0.196;
  const Grid grid = binarize(map, {});
  const TestFolder folder;
  const std::string file = folder.write("a.gridmap", gridmapBytes(map, grid));

  const GreyMap again = loadGrid(file, {});
  EXPECT_EQ(binarize(again, {}).cells, grid.cells);
  EXPECT_NEAR(again.frame.origin.x, -1.5, 1e-6);
  EXPECT_NEAR(again.frame.origin.y, 0.625, 1e-6);
  EXPECT_NEAR(again.grey[7], 254, 3) << "how sure a cell is, is kept";

  mrpt::maps::COccupancyGridMap2D object;
  mrpt::io::CFileGZInputStream stream(file);
  mrpt::serialization::archiveFrom(stream) >> object;
  EXPECT_EQ(object.getSizeX(), 5u);
  EXPECT_EQ(object.getSizeY(), 2u);
  EXPECT_FLOAT_EQ(object.getXMin(), -1.5f);
  EXPECT_LT(object.getCell(0, 0), 0.1f);
  EXPECT_GT(object.getCell(2, 1), 0.9f);
}

}  // namespace
}  // namespace roomgraph
