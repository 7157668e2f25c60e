#include "roomgraph/grid/binarize.h"

#include <gtest/gtest.h>

#include <cmath>

#include "roomgraph/base/Error.h"

namespace roomgraph::test {
namespace {

GreyMap greyMapOf(std::vector<std::uint8_t> grey) {
  GreyMap map;
  map.frame = {int(grey.size()), 1, 0.1, {}};
  map.grey = std::move(grey);
  return map;
}

TEST(Binarize, usesTheThresholdsOfTheFormat) {
  GreyMap map = greyMapOf({0, 80, 128, 180, 255});
  map.occupiedAbove = 0.65;
  map.freeBelow = 0.35;
  const std::vector<State> expected{State::occupied, State::occupied, State::unknown, State::free,
                                    State::free};
  EXPECT_EQ(binarize(map, {}).cells, expected);
}

TEST(Binarize, aMapWithoutFormatHasUnknownCells) {
  const std::vector<State> expected{State::occupied, State::unknown, State::unknown, State::free};
  EXPECT_EQ(binarize(greyMapOf({0, 128, 205 - 1, 254}), {}).cells, expected);
}

TEST(Binarize, refusesCellsThatTheFrameDoesNotHave) {
  GreyMap map = greyMapOf({0, 128, 255});
  for (const GridFrame& frame :
       {GridFrame{2, 1, 0.1, {}}, GridFrame{4, 1, 0.1, {}}, GridFrame{-3, -1, 0.1, {}},
        GridFrame{3, 1, 0, {}}, GridFrame{3, 1, NAN, {}}, GridFrame{3, 1, 0.1, {NAN, 0}},
        GridFrame{3, 1, 0.1, {0, 1e9}}}) {
    map.frame = frame;
    EXPECT_THROW((void)binarize(map, {}), UsageError);
  }
}

TEST(Binarize, optionsOverrideTheFormat) {
  GreyMap map = greyMapOf({0, 80, 255});
  BinarizeOptions options;
  options.occupiedAbove = 0.9;
  options.freeBelow = 0.05;
  const std::vector<State> expected{State::occupied, State::unknown, State::free};
  EXPECT_EQ(binarize(map, options).cells, expected);
}

TEST(Binarize, thePapersThresholdKnowsTwoStates) {
  // The sum of three equal channels of 33 is 99, of 34 is 102.
  BinarizeOptions options;
  options.blackThreshold = 100;
  const std::vector<State> expected{State::occupied, State::occupied, State::free, State::free};
  EXPECT_EQ(binarize(greyMapOf({0, 33, 34, 128}), options).cells, expected);
}

TEST(Binarize, aLevelAtAThresholdIsDecided) {
  GreyMap map = greyMapOf({0, 128, 255});  // the outer two are probabilities of 1 and 0
  map.occupiedAbove = 1;
  map.freeBelow = 0;
  const std::vector<State> expected{State::occupied, State::unknown, State::free};
  EXPECT_EQ(binarize(map, {}).cells, expected);
}

}  // namespace
}  // namespace roomgraph::test
