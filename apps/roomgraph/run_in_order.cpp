#include "run_in_order.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include "terminal.h"

namespace roomgraph {
namespace {

/** A bar on stderr that shows how much of a long piece of work is done. Silent where stderr is no
 *  terminal, and during the first second. Used by one thread. */
class ProgressBar {
 public:
  ProgressBar(std::size_t total, bool isWanted)
      : total_(total), isWanted_(isWanted && total > 0 && isatty(STDERR_FILENO) != 0) {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (!isWanted_ || elapsed.count() < 1) return;
    constexpr std::size_t kWidth = 40;
    const std::size_t filled = done * kWidth / total_;
    std::fprintf(stderr, "\r[%s%s] %3d %% %4.0f s", std::string(filled, '#').c_str(),
                 std::string(kWidth - filled, ' ').c_str(), int(done * 100 / total_),
                 elapsed.count());
    std::fflush(stderr);
    isShown_ = true;
  }

  /** Takes the bar off the screen, so that other lines can be printed. */
  void clear() {
    if (isShown_) std::fputs("\r\x1b[K", stderr);
    isShown_ = false;
  }

 private:
  std::size_t total_;
  bool isWanted_, isShown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/** The jobs and what they have said so far, shared by all threads. */
class Board {
 public:
  explicit Board(const JobList& jobs) : jobs_(jobs), reports_(jobs.count) {}

  /** What each worker does: takes the next job until none is left. */
  void work() {
    for (std::size_t i = next_++; i < jobs_.count; i = next_++) {
      try {
        set(i, jobs_.run(i, [this] { ++stepsDone_; }));
      } catch (...) {
        stop(i, std::current_exception());
      }
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

  /** What the first of the jobs that threw has thrown. To be called when no worker is left. */
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void set(std::size_t index, JobReport report) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reports_[index] = std::move(report);
    changed_.notify_all();
  }

  /** All jobs that no worker has taken yet stay undone. */
  void stop(std::size_t index, const std::exception_ptr& failure) {
    for (std::size_t i = next_.exchange(jobs_.count); i < jobs_.count; ++i) set(i, {});
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_ || index < failed_) failure_ = failure, failed_ = index;
    }
    set(index, {});
  }

  const JobList& jobs_;
  std::vector<std::optional<JobReport>> reports_;
  std::atomic<std::size_t> next_{0}, stepsDone_{0};
  std::exception_ptr failure_;
  std::size_t failed_ = 0;  ///< the job that threw it
  std::mutex mutex_;
  std::condition_variable changed_;
};

/** As many as asked for, or as the system has left; where it has none, all work is done at once. */
std::vector<std::thread> startWorkers(Board& board, std::size_t count) {
  std::vector<std::thread> workers;
  try {
    for (std::size_t i = 0; i < count; ++i) workers.emplace_back([&board] { board.work(); });
  } catch (const std::system_error&) {
    if (workers.empty()) board.work();
  }
  return workers;
}

}  // namespace

int runInOrder(const JobList& jobs, std::size_t threads, bool showProgress) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  Board board(jobs);
  std::vector<std::thread> workers = startWorkers(board, std::min(threads, jobs.count));
  ProgressBar bar(jobs.count * jobs.stepsPerJob, showProgress);
  int exitCode = 0;
  for (std::size_t i = 0; i < jobs.count; ++i) {
    const JobReport report = board.take(i, bar);
    bar.clear();
    std::fputs(report.err.c_str(), stderr);
    print(report.out);
    exitCode = std::max(exitCode, report.exitCode);
  }
  for (std::thread& worker : workers) worker.join();
  board.rethrow();
  return exitCode;
}

ForEach onThreads(std::size_t threads, bool showProgress) {
  return [threads, showProgress](std::size_t count, const std::function<void(std::size_t)>& job) {
    JobList jobs;
    jobs.count = count;
    jobs.run = [&](std::size_t i, const std::function<void()>& stepDone) {
      job(i);
      stepDone();
      return JobReport();
    };
    runInOrder(jobs, threads, showProgress);
  };
}

}  // namespace roomgraph
