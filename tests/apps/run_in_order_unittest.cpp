#include "run_in_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace roomgraph {
namespace {

JobList jobsThat(std::size_t count, const std::function<JobReport(std::size_t)>& work) {
  JobList jobs;
  jobs.count = count;
  jobs.run = [work](std::size_t i, const std::function<void()>&) { return work(i); };
  return jobs;
}

TEST(RunInOrder, printsInTheOrderOfTheJobs) {
  testing::internal::CaptureStdout();
  const JobList jobs = jobsThat(50, [](std::size_t i) {
    return JobReport{std::to_string(i) + "\n", "", i == 7 ? 3 : 0};
  });
  EXPECT_EQ(runInOrder(jobs, 8, false), 3);
  std::string expected;
  for (int i = 0; i < 50; ++i) expected += std::to_string(i) + "\n";
  EXPECT_EQ(testing::internal::GetCapturedStdout(), expected);
}

TEST(RunInOrder, whatAJobThrowsReachesTheCaller) {
  for (const std::size_t threads : {1, 2, 20}) {
    std::atomic<int> done{0};
    const JobList jobs = jobsThat(1000, [&](std::size_t i) {
      if (i == 5 || i == 6) throw std::runtime_error("job " + std::to_string(i));
      ++done;
      return JobReport();
    });
    try {
      runInOrder(jobs, threads, false);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "job 5") << "the first one, on any number of threads";
    }
    EXPECT_GE(done, 5) << "those before it were begun";
  }
}

}  // namespace
}  // namespace roomgraph
