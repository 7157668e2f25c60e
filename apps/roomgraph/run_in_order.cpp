#include "run_in_order.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ProgressBar.h"

namespace roomgraph {
namespace {

/** The jobs and what they have said so far, shared by all threads. */
class Board {
 public:
  explicit Board(const JobList& jobs) : jobs_(jobs), reports_(jobs.count) {}

  /** What each worker does: takes the next job until none is left. */
  void work() {
    for (std::size_t i = next_++; i < jobs_.count; i = next_++) {
      JobReport report = jobs_.run(i, [this] { ++stepsDone_; });
      const std::lock_guard<std::mutex> lock(mutex_);
      reports_[i] = std::move(report);
      changed_.notify_all();
    }
  }

  /** Waits for the report of a job and takes it away. */
  JobReport take(std::size_t index, ProgressBar& bar) {
    std::unique_lock<std::mutex> lock(mutex_);
    constexpr auto kRefresh = std::chrono::milliseconds(200);
    while (!changed_.wait_for(lock, kRefresh, [&] { return reports_[index].has_value(); }))
      bar.show(stepsDone_);
    JobReport report = std::move(*reports_[index]);
    reports_[index] = JobReport{};
    return report;
  }

 private:
  const JobList& jobs_;
  std::vector<std::optional<JobReport>> reports_;
  std::atomic<std::size_t> next_{0}, stepsDone_{0};
  std::mutex mutex_;
  std::condition_variable changed_;
};

}  // namespace

int runInOrder(const JobList& jobs, std::size_t threads, bool showProgress) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  Board board(jobs);
  std::vector<std::thread> workers;
  for (std::size_t i = 0; i < std::min(threads, jobs.count); ++i)
    workers.emplace_back([&board] { board.work(); });
  ProgressBar bar(jobs.count * jobs.stepsPerJob, showProgress);
  int exitCode = 0;
  for (std::size_t i = 0; i < jobs.count; ++i) {
    const JobReport report = board.take(i, bar);
    bar.clear();
    std::fputs(report.err.c_str(), stderr);
    std::fputs(report.out.c_str(), stdout);
    std::fflush(stdout);
    exitCode = std::max(exitCode, report.exitCode);
  }
  for (std::thread& worker : workers) worker.join();
  return exitCode;
}

}  // namespace roomgraph
