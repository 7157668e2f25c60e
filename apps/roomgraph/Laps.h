#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** How long the steps of a call take, for --timings. The first begins when it is made. */
class Laps {
 public:
  /** What was done since the last step ended was `step`. */
  void end(const std::string& step);
  /** The same of several steps that were timed by themselves. */
  void end(const std::vector<StageTiming>& steps);

  /** A line for `title`, one for each step and one for all, each with its line end. */
  std::string table(const std::string& title) const;

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTiming> steps_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace roomgraph
