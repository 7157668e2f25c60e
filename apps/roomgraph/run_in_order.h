#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "roomgraph/base/ForEach.h"

namespace roomgraph {

/** What one job has to say. */
struct JobReport {
  std::string out, err;  ///< for stdout and stderr, whole lines
  int exitCode = 0;
  std::function<void()> stepDone{};  ///< to be called after each of its steps but the last
};

struct JobList {
  std::size_t count = 0;
  /** Does job `index` and fills in its report. Runs on any thread. */
  std::function<void(std::size_t index, JobReport& report)> run;
  /** The file that a job is done for: what the job throws then is told in its report. */
  std::function<std::string(std::size_t index)> fileOf{};
  std::size_t stepsPerJob = 1;  ///< for the bar of their progress
};

/** Runs the jobs on `threads` threads, 0 standing for one per core, and prints what each has to say
 *  in the order of the jobs, as soon as those before it are done. Returns the largest exit code.
 *  Where jobs without files throw, no further job begins, and what the first of them has thrown is
 *  thrown again. */
int runInOrder(const JobList& jobs, std::size_t threads, bool showProgress);

/** Jobs on so many threads, with a bar of their progress where it is wanted. */
ForEach onThreads(std::size_t threads, bool showProgress);

}  // namespace roomgraph
