#include "roomgraph/grid/load_keyframes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "map_files.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(LoadKeyframes, givesEachScanWithWhatItsBeamsMet) {
  const test::TempDir dir;
  const auto frames =
      loadKeyframes(dir.write("map", test::gzipped(test::streamed(test::smallSimplemap()))), 30);
  ASSERT_EQ(frames.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(frames[i].pose.x, 0.5 * double(i) - 0.5);
    EXPECT_EQ(frames[i].pose.phi, 0);
    EXPECT_EQ(frames[i].ends.size(), 39u) << "one beam has no return";
    for (const Point end : frames[i].ends) {
      const Point at = frames[i].pose(end);  // on the walls of the square room
      EXPECT_NEAR(std::max(std::abs(at.x), std::abs(at.y)), 2, 1e-5);
    }
  }
}

TEST(LoadKeyframes, leavesOutWhatIsTooFar) {
  const test::TempDir dir;
  const std::string file = dir.write("map", test::streamed(test::smallSimplemap()));
  for (const Keyframe& frame : loadKeyframes(file, 2.2)) {
    EXPECT_LT(frame.ends.size(), 39u);
    for (const Point end : frame.ends) EXPECT_LE(norm(end), 2.2);
  }
}

TEST(LoadKeyframes, otherMapsHaveNone) {
  const test::TempDir dir;
  EXPECT_TRUE(loadKeyframes(dir.write("map", test::streamed(test::smallGrid())), 30).empty());
  EXPECT_TRUE(loadKeyframes(dir.write("map.yaml", "image: map.png\n"), 30).empty());
}

TEST(LoadKeyframes, aDamagedFileIsRefused) {
  const test::TempDir dir;
  const std::string bytes = test::streamed(test::smallSimplemap());
  EXPECT_THROW(loadKeyframes(dir.write("map", bytes.substr(0, bytes.size() / 2)), 30), DataError);
  EXPECT_THROW(loadKeyframes(dir.path("none"), 30), DataError);
}

}  // namespace
}  // namespace roomgraph
