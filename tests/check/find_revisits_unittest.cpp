#include "roomgraph/check/find_revisits.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

std::vector<Revisit> revisits(const std::vector<Keyframe>& frames,
                              const std::vector<Transform2D>& poses) {
  return findRevisits(localScans(test::runOf(frames).scans), poses);
}

TEST(FindRevisits, whatWasDrivenOnceHasNone) {
  const auto& once = test::driveOnce();
  const std::vector<Keyframe> half(once.begin(), once.begin() + 20);
  EXPECT_TRUE(revisits(half, test::posesOf(half)).empty());
  EXPECT_TRUE(findRevisits({}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
