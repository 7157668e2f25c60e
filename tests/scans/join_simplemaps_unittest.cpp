#include <gtest/gtest.h>

#include "map_files.h"
#include "newer_simplemap.h"
#include "recording_in.h"
#include "roomgraph/scans/rewrite_simplemap.h"

namespace roomgraph {
namespace {

using test::recordingIn;

SimplemapPart partOf(const std::string& bytes, const std::vector<std::size_t>& frames) {
  return {bytes, recordingIn(bytes), frames};
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
  const Recording joined = recordingIn(joinSimplemaps({partOf(older, {0, 2}), partOf(newer, {1})}));
  EXPECT_EQ(joined.version, 2);
  ASSERT_EQ(joined.frames.size(), 3u);
  EXPECT_EQ(joined.frames[1].robot, recordingIn(older).frames[2].robot);
  EXPECT_EQ(joined.frames[2].robot, recordingIn(newer).frames[1].robot);
  EXPECT_EQ(joined.frames[2].time(), recordingIn(newer).frames[1].time());
}

}  // namespace
}  // namespace roomgraph
