#include <gtest/gtest.h>

#include "map_files.h"
#include "newer_simplemap.h"
#include "roomgraph/scans/StoredPose.h"
#include "roomgraph/scans/rewrite_simplemap.h"
#include "stored_in.h"

namespace roomgraph {
namespace {

using test::storedIn;

SimplemapPart partOf(const std::string& bytes, const std::vector<std::size_t>& frames) {
  return {bytes, storedIn(bytes), frames};
}

TEST(JoinSimplemaps, allOfOneIsThatOne) {
  for (const int version : {1, 2}) {
    const std::string bytes =
        test::asNewer(test::smallSimplemap(), {version, false, 7, true, true});
    EXPECT_EQ(joinSimplemaps({partOf(bytes, {0, 1, 2, 3, 4, 5})}), bytes);
  }
  EXPECT_EQ(joinSimplemaps({}), "");
}

TEST(JoinSimplemaps, partsOfAnyVersionsAreReadBack) {
  const std::string older = test::asNewer(test::smallSimplemap(), {1, false, 7, false, false});
  const std::string newer = test::asNewer(test::smallSimplemap(), {2, true, 8, false, false});
  const StoredPoses joined = storedIn(joinSimplemaps({partOf(older, {0, 2}), partOf(newer, {1})}));
  EXPECT_EQ(joined.mapVersion, 2);
  ASSERT_EQ(joined.frames.size(), 3u);
  EXPECT_EQ(joined.frames[1].place, storedIn(older).frames[2].place);
  EXPECT_EQ(joined.frames[2].place, storedIn(newer).frames[1].place);
  EXPECT_EQ(joined.frames[2].time, storedIn(newer).frames[1].time);
}

}  // namespace
}  // namespace roomgraph
