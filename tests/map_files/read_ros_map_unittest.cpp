#include <gtest/gtest.h>

#include <cmath>

#include "TestFolder.h"
#include "map_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

constexpr State u = State::unknown, f = State::free, o = State::occupied;
using States = std::vector<State>;

/** A ROS map whose picture and yaml the test writes. */
class RosRules : public testing::Test {
 protected:
  /** `pixels` are the text of a pgm of one row. */
  GreyMap load(int count, const std::string& pixels, const std::string& more) const {
    return loadPicture("map.pgm", "P2 " + std::to_string(count) + " 1 255 " + pixels, more);
  }
  States states(int count, const std::string& pixels, const std::string& more) const {
    return binarize(load(count, pixels, more + "origin: [0, 0, 0]\n"), {}).cells;
  }
  GreyMap loadPicture(const std::string& name, const std::string& bytes,
                      const std::string& more) const {
    dir_.write(name, bytes);
    return loadGrid(dir_.write("map.yaml", "image: " + name + "\nresolution: 0.5\n" + more), {});
  }
  const TestFolder dir_;
};

TEST_F(RosRules, aCellAtAThresholdIsDecidedByIt) {
  // 102 is a probability of 0.6, 204 one of 0.2.
  EXPECT_EQ(states(4, "102 103 203 204", "occupied_thresh: 0.6\nfree_thresh: 0.2\n"),
            (States{o, u, u, f}));
}

TEST_F(RosRules, negatedCellsAtAThresholdAreDecidedByItToo) {
  EXPECT_EQ(states(4, "153 152 52 51", "negate: 1\noccupied_thresh: 0.6\nfree_thresh: 0.2\n"),
            (States{o, u, u, f}));
}

TEST_F(RosRules, scaleUsesTheSameThresholds) {
  EXPECT_EQ(states(4, "102 103 203 204", "mode: scale\noccupied_thresh: 0.6\nfree_thresh: 0.2\n"),
            (States{o, u, u, f}));
}

TEST_F(RosRules, rawPixelsArePercentsAndMeetTheThresholdsExactly) {
  EXPECT_EQ(states(6, "0 25 26 64 65 100", "mode: raw\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"),
            (States{f, f, u, u, o, o}));
  EXPECT_EQ(states(3, "101 200 255", "mode: raw\noccupied_thresh: 0.5\nfree_thresh: 0.49\n"),
            (States{u, u, u}));
  EXPECT_EQ(states(2, "49 50", "mode: raw\noccupied_thresh: 0.5\nfree_thresh: 0.49\n"),
            (States{f, o}));
}

TEST_F(RosRules, aPixelThatIsNotOpaqueIsUnknown) {
  const std::string pixels = {char(254), char(254), 0, char(255), 0, char(255)};
  for (const std::string mode : {"trinary", "scale", "raw"}) {
    const GreyMap map = loadPicture("map.png", test::png(3, 1, 2, pixels),
                                    "origin: [0, 0, 0]\nfree_thresh: 0.6\noccupied_thresh: 0.65\n"
                                    "mode: " +
                                        mode);
    EXPECT_EQ(binarize(map, {}).cells[0], u) << mode;
    EXPECT_EQ(binarize(map, {}).cells[1], mode == "raw" ? f : o) << mode;
  }
}

TEST_F(RosRules, humblesUnknownStaysUnknown) {
  const GreyMap map =
      load(4, "0 205 205 254", "origin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.25\n");
  EXPECT_EQ(binarize(map, {}).cells, (States{o, u, u, f}));
  ASSERT_EQ(map.notes.size(), 1u);
  EXPECT_EQ(map.notes[0].code, "humble_thresholds");
}

TEST_F(RosRules, thresholdsThatAreMissingAreNoted) {
  const std::string origin = "origin: [0, 0, 0]\n", one = origin + "occupied_thresh: 0.7\n";
  for (const std::string& yaml : {origin, one}) {
    const GreyMap map = load(2, "0 254", yaml);
    ASSERT_EQ(map.notes.size(), 1u);
    EXPECT_EQ(map.notes[0].code, "default_thresholds");
    EXPECT_NE(map.notes[0].text.find(yaml == one ? "0.7 and 0.196" : "0.65 and 0.196"),
              std::string::npos)
        << map.notes[0].text;
  }
  EXPECT_TRUE(load(2, "0 254", one + "free_thresh: 0.2\n").notes.empty());
}

TEST_F(RosRules, theSameThresholdMeantAsItIsWrittenIsKept) {
  const std::string humble = "origin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";
  // Drawn in greys, raw, or without the grey of unknown cells.
  for (const GreyMap& map :
       {load(4, "0 198 205 254", humble), load(4, "0 90 205 25", humble + "mode: raw\n"),
        load(4, "0 128 215 254", humble)}) {
    EXPECT_TRUE(map.notes.empty());
    EXPECT_NEAR(map.freeBelow, 0.25, 0.005);
  }
}

TEST_F(RosRules, picturesMayBeBmpOrJpeg) {
  const std::string origin = "origin: [1, 2, 0]\n";
  const std::string bmp = "BM" + test::raw<std::uint32_t>(30) + test::raw<std::uint32_t>(0) +
                          test::raw<std::uint32_t>(26) + test::raw<std::uint32_t>(12) +
                          test::raw<std::uint16_t>(1) + test::raw<std::uint16_t>(1) +
                          test::raw<std::uint16_t>(1) + test::raw<std::uint16_t>(24) +
                          std::string(4, '\0');
  EXPECT_EQ(binarize(loadPicture("map.bmp", bmp, origin), {}).cells, (States{o}));
  const std::string jpeg = test::jpeg(8, 8, 1, std::string(64, char(254)));
  EXPECT_EQ(binarize(loadPicture("map.jpg", jpeg, origin), {}).cells, States(64, f));
}

/** A wall of 3 cells to the right from the origin, free cells above it. */
const std::string kCorner = "P2 3 2 255 254 254 205 0 0 0";

TEST_F(RosRules, aQuarterTurnMovesWholeCells) {
  const GreyMap map =
      loadPicture("map.pgm", kCorner,
                  "origin: [10, 20, 1.5707963]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  ASSERT_EQ(map.frame.width, 2);
  ASSERT_EQ(map.frame.height, 3);
  EXPECT_NEAR(map.frame.origin.x, 9, 1e-9);  // 2 cells of 0.5 m to the left of the pivot
  EXPECT_NEAR(map.frame.origin.y, 20, 1e-9);
  // The wall now leads up along x = 10.
  EXPECT_EQ(map.grey, (std::vector<std::uint8_t>{254, 0, 254, 0, 205, 0}));
  ASSERT_EQ(map.notes.size(), 1u);
  EXPECT_EQ(map.notes[0].code, "turned");
}

TEST_F(RosRules, turnsOfWholeCirclesChangeNothing) {
  const GreyMap still = loadPicture("map.pgm", kCorner, "origin: [10, 20, 0]\n");
  const GreyMap map = loadPicture("map.pgm", kCorner, "origin: [10, 20, -6.283185]\n");
  EXPECT_EQ(map.grey, still.grey);
  EXPECT_NEAR(map.frame.origin.x, 10, 1e-9);
}

/** A square room of `side` cells with walls a cell thick. */
std::string room(int side) {
  std::string text = "P2 " + std::to_string(side) + " " + std::to_string(side) + " 255";
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      text += x % (side - 1) == 0 || y % (side - 1) == 0 ? " 0" : " 254";
  return text;
}

TEST_F(RosRules, aTurnedMapKeepsItsWallsAndItsPlace) {
  const GreyMap map = loadPicture("map.pgm", room(41), "origin: [3, 4, 0.5235988]\n");
  const Grid grid = binarize(map, {});
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  for (int i = 0; i < 41; ++i)
    for (int k = 0; k < 41; ++k) {
      const double x = (i + 0.5) * 0.5, y = (k + 0.5) * 0.5;
      const State state =
          grid.atOrUnknown(grid.frame.cellAt({3 + c * x - s * y, 4 + s * x + c * y}));
      const bool isWall = i % 40 == 0 || k % 40 == 0;
      const bool isBeside = !isWall && (i == 1 || k == 1 || i == 39 || k == 39);
      if (!isBeside) {
        EXPECT_EQ(state, isWall ? o : f) << i << " " << k;
      }
    }
  EXPECT_EQ(grid.at({0, 0}), u) << "outside of the turned picture";
  for (int y = 0; y < grid.frame.height; ++y)  // no free cell looks out through the wall
    for (int x = 0; x < grid.frame.width; ++x) {
      if (grid.at({x, y}) != f) continue;
      for (const Cell d : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}})
        EXPECT_NE(grid.atOrUnknown({x + d.x, y + d.y}), u) << x << " " << y;
    }
}

TEST_F(RosRules, aTurnThatMakesAMapTooLargeIsRefused) {
  // As long as is allowed: turned it would take a square.
  EXPECT_THROW(
      loadPicture("map.pgm", "P5 60000 1 255\n" + std::string(60000, 'x'), "origin: [0, 0, 0.7]\n"),
      DataError);
}

TEST_F(RosRules, nav2sOwnMapsAreReadAsNav2Does) {
  const std::string plain = test::sharedFile("mrpt_new/nav2/tb3_sandbox.yaml");
  const std::string saved = test::sharedFile("mrpt_new/nav2/tb3_sandbox_humble.yaml");
  if (plain.empty() || saved.empty()) GTEST_SKIP() << "nav2's maps are not beside the source tree";
  const GreyMap humble = loadGrid(saved, {});
  EXPECT_EQ(binarize(humble, {}).cells, binarize(loadGrid(plain, {}), {}).cells);
  EXPECT_EQ(humble.notes.size(), 1u);
}

}  // namespace
}  // namespace roomgraph
