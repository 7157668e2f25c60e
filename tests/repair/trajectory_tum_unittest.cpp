#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "roomgraph/repair/key_frame_moves.h"

namespace roomgraph {
namespace {

Recording atTimes(const std::vector<std::optional<double>>& times) {
  Recording recording;
  for (const auto& time : times) {
    Recording::Frame& frame = recording.frames.emplace_back();
    frame.robot = mrpt::poses::CPose3D(1, 2, 0.5, 0, 0, 0);
    if (time) frame.scans.emplace_back().time = mrpt::Clock::fromDouble(*time);
  }
  return recording;
}

TEST(TrajectoryTum, isALineForEachKeyFrame) {
  const std::string text = trajectoryTum(atTimes({10.5}), {{{0, 1, M_PI / 2}, {}}});
  EXPECT_EQ(text,
            "10.500000 -2.000000 2.000000 0.500000 0.000000000 0.000000000 0.707106781 "
            "0.707106781\n");
}

std::vector<std::string> timesIn(const Recording& recording) {
  const std::string text = trajectoryTum(recording, std::vector<PoseMove>(recording.frames.size()));
  std::vector<std::string> times;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    times.push_back(text.substr(at, text.find(' ', at) - at));
  return times;
}

TEST(TrajectoryTum, timesThatAreMissingLieBetweenThoseThatAreThere) {
  EXPECT_EQ(timesIn(atTimes({{}, 1, {}, 3, {}})),
            (std::vector<std::string>{"1.000000", "1.000000", "2.000000", "3.000000", "3.000000"}));
  EXPECT_EQ(timesIn(atTimes({{}, {}})), (std::vector<std::string>{"0.000000", "1.000000"}));
}

}  // namespace
}  // namespace roomgraph
