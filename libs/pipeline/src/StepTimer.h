#pragma once
#include <chrono>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** Notes how long each step took that sets a member of some Stages:
 *
 *      step("voronoi_graph").voronoi = voronoiGraph(s.obstacles);
 *
 *  The right side of an assignment comes first: so the time since the last step is this one's. */
class StepTimer {
 public:
  explicit StepTimer(Stages& stages) : stages_(stages) {}

  Stages& operator()(const char* name) {
    const auto now = Clock::now();
    stages_.timings.push_back({name, std::chrono::duration<double>(now - last_).count()});
    last_ = now;
    return stages_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  Stages& stages_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace roomgraph
