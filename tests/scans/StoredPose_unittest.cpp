#include "roomgraph/scans/StoredPose.h"

#include <gtest/gtest.h>

#include "map_files.h"
#include "newer_simplemap.h"
#include "roomgraph/base/Error.h"
#include "stored_in.h"

namespace roomgraph {
namespace {

using test::storedIn;

TEST(ReadStoredPoses, tellsKeyFramesWithoutScansToo) {
  const StoredPoses stored =
      storedIn(test::asNewer(test::smallSimplemap(), {2, true, 8, true, true}));
  ASSERT_EQ(stored.frames.size(), 6u);
  EXPECT_NEAR(*stored.frames[0].time, 1.7e9 - 0.5, 1e-6);
  EXPECT_FALSE(stored.frames[1].time);
  EXPECT_EQ(stored.frames[0].place, stored.frames[1].place);
  for (std::size_t k = 1; k < 6; ++k) EXPECT_EQ(stored.frames[k].begin, stored.frames[k - 1].end);
}

TEST(ReadStoredPoses, refusesWhatIsCutShort) {
  const std::string bytes = test::streamed(test::smallSimplemap());
  EXPECT_THROW(storedIn(bytes.substr(0, 900)), DataError);
}

}  // namespace
}  // namespace roomgraph
