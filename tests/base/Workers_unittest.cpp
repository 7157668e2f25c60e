#include "roomgraph/base/Workers.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace roomgraph {
namespace {

TEST(Workers, doEachJobOnce) {
  for (const std::size_t threads : {0, 1, 8}) {
    std::vector<std::atomic<int>> times(100);
    std::size_t last = 0;
    Workers(threads, times.size(), [&](std::size_t i) { ++times[i]; }).wait([&](std::size_t done) {
      EXPECT_GE(done, last);
      last = done;
    });
    EXPECT_EQ(last, times.size());
    for (const std::atomic<int>& done : times) EXPECT_EQ(done, 1);
  }
}

TEST(Workers, withoutJobsThereIsNothingToTell) {
  Workers(4, 0, [](std::size_t) {}).wait([](std::size_t) { ADD_FAILURE(); });
}

TEST(Workers, beginNoJobOnceTheTellerHasThrown) {
  std::atomic<int> begun{0};
  const auto job = [&](std::size_t) {
    ++begun;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  const auto tell = [](std::size_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(Workers(2, 100'000, job).wait(tell), std::runtime_error);
  EXPECT_LT(begun, 100'000);
}

}  // namespace
}  // namespace roomgraph
