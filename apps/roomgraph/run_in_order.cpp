#include "run_in_order.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "roomgraph/base/Workers.h"
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

}  // namespace

int runInOrder(const JobList& jobs, std::size_t threads, bool showProgress) {
  std::mutex mutex;
  std::vector<std::optional<JobReport>> reports(jobs.count);  // which no thread has printed
  std::atomic<std::size_t> stepsDone{0};
  ProgressBar bar(jobs.count * jobs.stepsPerJob, showProgress);
  int exitCode = 0;
  std::size_t next = 0;
  const auto takeNext = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return next < jobs.count ? std::exchange(reports[next], std::nullopt) : std::nullopt;
  };
  Workers workers(threads, jobs.count, [&](std::size_t i) {
    JobReport report;
    report.stepDone = [&] { ++stepsDone; };
    try {
      jobs.run(i, report);
      ++stepsDone;
    } catch (...) {
      if (!jobs.fileOf) throw;
      const Failure failure = currentFailure(jobs.fileOf(i));
      report.err += failure.line, report.exitCode = failure.exitCode;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    reports[i] = std::move(report);
  });
  workers.wait([&](std::size_t) {
    bar.show(stepsDone);
    for (; const auto report = takeNext(); ++next) {
      bar.clear();
      std::fputs(report->err.c_str(), stderr);
      print(report->out);
      exitCode = std::max(exitCode, report->exitCode);
    }
  });
  return exitCode;
}

ForEach onThreads(std::size_t threads, bool showProgress) {
  return [threads, showProgress](std::size_t count, const std::function<void(std::size_t)>& job) {
    runInOrder({count, [&](std::size_t i, JobReport&) { job(i); }}, threads, showProgress);
  };
}

}  // namespace roomgraph
