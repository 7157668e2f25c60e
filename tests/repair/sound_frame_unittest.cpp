#include "roomgraph/repair/sound_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

/** Along a line of 20 m, from the `torn`-th on turned and shifted. */
std::vector<Transform2D> line(std::size_t torn = 40) {
  std::vector<Transform2D> poses;
  const Transform2D jump{3, 5, 1};
  for (std::size_t k = 0; k < 40; ++k) {
    const Transform2D pose{0.5 * double(k), 0, 0.1};
    poses.push_back(k < torn ? pose : jump * pose);
  }
  return poses;
}

const Transform2D kSite{-4, 7, 2};

std::vector<Transform2D> inSite(std::vector<Transform2D> poses) {
  for (Transform2D& pose : poses) pose = kSite * pose;
  return poses;
}

void expectSame(const Transform2D& l, const Transform2D& r, double most) {
  EXPECT_LT(poseDistance(l, r), most);
}

TEST(SoundFrame, theLargerPartOfATornRunStays) {
  expectSame(soundFrame(line(28), inSite(line())), kSite.inverse(), 1e-6);
  const Transform2D rest = soundFrame(line(12), inSite(line()));
  expectSame(rest * inSite(line())[30], line(12)[30], 1e-6);
}

TEST(SoundFrame, smallErrorsAreShared) {
  std::vector<Transform2D> were = line();
  for (std::size_t k = 0; k < were.size(); ++k) were[k].y += k % 2 ? 0.02 : -0.02;
  expectSame(soundFrame(were, inSite(line())), kSite.inverse(), 0.01);
}

TEST(SoundFrame, ofNothingOrOnePose) {
  expectSame(soundFrame({}, {}), {}, 1e-12);
  expectSame(soundFrame({{1, 2, 3}}, {kSite}) * kSite, {1, 2, 3}, 1e-9);
}

TEST(PoseDistance, turnsCountByWhatIsDrawn) {
  EXPECT_NEAR(poseDistance({3, 4, 1}, {0, 0, 1}), 5, 1e-12);
  EXPECT_NEAR(poseDistance({0, 0, 0.02}, {0, 0, 0}), 0.2, 1e-4);
  EXPECT_NEAR(poseDistance({0, 0, M_PI}, {0, 0, -M_PI}), 0, 1e-9);
}

}  // namespace
}  // namespace roomgraph
