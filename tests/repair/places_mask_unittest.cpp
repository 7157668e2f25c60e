#include <gtest/gtest.h>

#include <algorithm>

#include "TestFolder.h"
#include "carried_by.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/images/read_image.h"
#include "roomgraph/map_files/ros_map_yaml.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

constexpr int kWidth = 60, kHeight = 40;
constexpr double kCell = 0.1;

/** A zone of 12 x 8 cells, half of it slower, a slanted wall of single cells, and a lone cell. */
std::string drawn() {
  std::string grey(kWidth * kHeight, char(254));
  const auto at = [&](int x, int y) -> char& { return grey[std::size_t(y * kWidth + x)]; };
  for (int x = 5; x < 17; ++x)
    for (int y = 5; y < 13; ++y) at(x, y) = char(x < 11 ? 0 : 100);
  for (int i = 0; i < 20; ++i) at(25 + i, 10 + i) = 0;
  at(50, 5) = 0;
  return grey;
}

std::string pgm() { return "P5\n60 40\n255\n" + drawn(); }

class PlacesMask : public testing::Test {
 protected:
  struct Written {
    RosMapYaml yaml;
    std::string text;
    GreyMap picture;
  };

  MarkedFile read(const std::string& picture, const std::string& bytes) {
    folder_.write(picture, bytes);
    return maskPlaces("image: " + picture +
                          "\nmode: scale\nresolution: 0.1\norigin: [1, 2, 0]\nnegate: 0\n"
                          "occupied_thresh: 1.0\nfree_thresh: 0.1\nfloor: 3\n",
                      folder_ / "mask.yaml");
  }

  Written carried(const MarkedFile& file, const Transform2D& motion) {
    const auto files = file.write(test::carriedBy(motion, file), frame());
    EXPECT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0].name, "mask.yaml");
    EXPECT_EQ(file.files, (std::vector<std::string>{files[0].name, files[1].name}));
    EXPECT_EQ(files[0].bytes.rfind(kRosMapMark, 0), 0u) << "it is ours from now on";
    Written written{readRosMapYaml(files[0].bytes, "mask.yaml"), files[0].bytes, {}};
    EXPECT_EQ(written.yaml.image, files[1].name);
    CheckedFile picture(folder_.write("carried_" + files[1].name, files[1].bytes));
    readImage(picture, written.picture);
    written.picture.frame.resolution = written.yaml.resolution;
    written.picture.frame.origin = written.yaml.origin;
    return written;
  }

  /** Of the new map. */
  static GridFrame frame() {
    GridFrame frame;
    frame.width = frame.height = 100, frame.resolution = 0.05, frame.origin = {0.02, 0};
    return frame;
  }

  static std::size_t cellsOf(const GreyMap& map, std::uint8_t grey) {
    return std::size_t(std::count(map.grey.begin(), map.grey.end(), grey));
  }

  TestFolder folder_;
};

TEST_F(PlacesMask, aMaskThatStaysIsTheSame) {
  const MarkedFile file = read("mask.pgm", pgm());
  ASSERT_EQ(file.things.size(), 3u);
  const Written there = carried(file, {});
  EXPECT_EQ(there.yaml.mode, "scale");
  EXPECT_NE(there.text.find("floor: 3\n"), std::string::npos);
  EXPECT_EQ(cellsOf(there.picture, 0), 48u + 20 + 1);
  EXPECT_EQ(cellsOf(there.picture, 100), 48u);
  const auto greyAt = [&](Point p) {
    return there.picture.grey[there.picture.frame.index(there.picture.frame.cellAt(p))];
  };
  // Rows are counted from the top of the picture, and the frame from its lower left corner.
  EXPECT_EQ(greyAt({1 + kCell * 5.5, 2 + kCell * (kHeight - 5.5)}), 0);
  EXPECT_EQ(greyAt({1 + kCell * 16.5, 2 + kCell * (kHeight - 5.5)}), 100);
  EXPECT_EQ(greyAt({1 + kCell * 17.5, 2 + kCell * (kHeight - 5.5)}), 254);
}

TEST_F(PlacesMask, nothingGetsLostHoweverItIsTurned) {
  const MarkedFile file = read("mask.png", test::png(kWidth, kHeight, 1, drawn()));
  for (const double turn : {0.1, 0.785398, 1.9, -2.6}) {
    const Written there = carried(file, {20, -5, turn});
    const GridFrame& at = there.picture.frame;
    std::vector<bool> isMarked;
    for (const std::uint8_t grey : there.picture.grey) isMarked.push_back(grey < 254);
    EXPECT_NEAR(double(cellsOf(there.picture, 100)), 48, 8) << turn;
    // Marked corners that touched go on touching: regions stay whole.
    const std::string again = "again.pgm";
    EXPECT_EQ(read(again, "P5\n" + std::to_string(at.width) + " " + std::to_string(at.height) +
                              "\n255\n" +
                              std::string(there.picture.grey.begin(), there.picture.grey.end()))
                  .things.size(),
              3u)
        << turn;
    // It covers the new map.
    EXPECT_LE(at.origin.x, 0.02);
    EXPECT_GE(at.origin.x + at.width * at.resolution, 5.02);
  }
}

TEST_F(PlacesMask, eachRegionTellsItsState) {
  const MarkedFile file = read("mask.pgm", pgm());
  EXPECT_EQ(file.things[1].name.rfind("2, at (", 0), 0u) << file.things[1].name;
  auto things = test::carriedBy({}, file);
  things[1].state = CarryState::gone, things[1].reason = "a wall";
  const std::string text = file.write(things, frame()).at(0).bytes;
  EXPECT_NE(text.find("state: gone, error_m: 0.05, reason: a wall}\n"), std::string::npos) << text;
  EXPECT_NE(text.find("area_m2: 0.2, state: carried, error_m: 0.05}\n"), std::string::npos) << text;
}

TEST_F(PlacesMask, aLoneCellIsAPlaceAndALargeRegionAnAreaThatMayTouchWalls) {
  const MarkedFile file = read("mask.pgm", pgm());
  const auto areAll = [&](std::size_t thing, bool isCorner) {
    const std::vector<std::size_t>& places = file.things[thing].places;
    return std::all_of(places.begin(), places.end(),
                       [&](std::size_t k) { return file.places[k].isCorner == isCorner; });
  };
  std::size_t lone = 0;
  for (std::size_t i = 0; i < file.things.size(); ++i) {
    const bool isLone = file.things[i].places.size() == 1;
    lone += isLone;
    EXPECT_TRUE(areAll(i, !isLone)) << i;
  }
  EXPECT_EQ(lone, 1u);
}

TEST_F(PlacesMask, picturesOfOtherKindsBecomePng) {
  const MarkedFile file = read("mask.jpg", test::jpeg(kWidth, kHeight, 1, drawn()));
  EXPECT_EQ(carried(file, {}).yaml.image, "mask.png");
}

TEST_F(PlacesMask, whatIsNoMaskIsRefused) {
  EXPECT_THROW(read("mask.pgm", "no picture"), DataError);
  EXPECT_THROW(
      maskPlaces("image: none.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n", folder_ / "mask.yaml"),
      DataError);
}

TEST_F(PlacesMask, zonesTooFarOutsideOfTheNewMapAreRefused) {
  const MarkedFile file = read("mask.pgm", pgm());
  const std::string line = test::refusalOf([&] { carried(file, {3000, 3000, 0}); });
  EXPECT_NE(line.find("on the new map it would have 300"), std::string::npos) << line;
  EXPECT_NE(line.find("take out the zones"), std::string::npos) << line;
}

}  // namespace
}  // namespace roomgraph
