#include "roomgraph/map_files/ros_map_yaml.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

const std::string kYaml =
    "image: \"../a b.pgm\"  # drawn by hand\nmode: scale\nresolution: 0.05\norigin: [-1, 2.5, "
    "0.1]\n"
    "negate: 1\nfloor: {number: 3, names: [ground, Erdgeschoss]}\n";

TEST(RosMapYaml, tellsWhatItSaysOfItsPicture) {
  const RosMapYaml map = readRosMapYaml(kYaml, "mask.yaml");
  EXPECT_EQ(map.image, "../a b.pgm");
  EXPECT_EQ(map.mode, "scale");
  EXPECT_EQ(map.origin, (Point{-1, 2.5}));
  EXPECT_EQ(map.yaw, 0.1);
  EXPECT_TRUE(map.negate);
  EXPECT_FALSE(map.hasThresholds);
  EXPECT_THROW(pictureOf(map, "mask.yaml"), DataError);
}

TEST(RosMapYaml, otherKeysStay) {
  const std::string text = rosMapYamlWith(
      kYaml,
      {{"image", "\"b: c.pgm\""}, {"origin", "[3, 4, 0]"}, {"zones", "[{\"x\": 1}, {\"x\": 2}]"}},
      "mask.yaml");
  EXPECT_EQ(text,
            "image: \"b: c.pgm\"\nmode: scale\nresolution: 0.05\norigin: [3, 4, 0]\nnegate: 1\n"
            "floor: {number: 3, names: [ground, Erdgeschoss]}\nzones:\n  - {x: 1}\n  - {x: 2}\n");
  EXPECT_THROW(rosMapYamlWith("origin: [0, 0, 0]", {}, "mask.yaml"), DataError);
}

}  // namespace
}  // namespace roomgraph
