#include "run_in_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

JobList jobsThat(std::size_t count, const std::function<JobReport(std::size_t)>& work) {
  return {count, [work](std::size_t i, JobReport& report) { report = work(i); }};
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

TEST(RunInOrder, whatAJobThrowsIsToldOfItsFile) {
  JobList jobs = jobsThat(3, [](std::size_t i) {
    if (i == 1) throw DataError("a.pgm: is empty");
    return JobReport{std::to_string(i) + "\n", "", 0};
  });
  jobs.fileOf = [](std::size_t) { return "a.pgm"; };
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(runInOrder(jobs, 2, false), 1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "0\n2\n");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "roomgraph: a.pgm: is empty\n");
}

}  // namespace
}  // namespace roomgraph
