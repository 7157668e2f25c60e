#pragma once
#include <chrono>
#include <functional>
#include <utility>
#include <vector>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** Calls steps and notes how long each took. */
class StepTimer {
 public:
  explicit StepTimer(std::vector<StageTiming>& timings) : timings_(timings) {}

  /** What step(inputs...) returns. */
  template <class Step, class... Inputs>
  auto operator()(const char* name, const Step& step, Inputs&&... inputs) const {
    const auto start = Clock::now();
    auto result = std::invoke(step, std::forward<Inputs>(inputs)...);
    timings_.push_back({name, std::chrono::duration<double>(Clock::now() - start).count()});
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTiming>& timings_;
};

}  // namespace roomgraph
