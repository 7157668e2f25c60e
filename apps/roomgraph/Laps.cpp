#include "Laps.h"

#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

void Laps::end(const std::string& step) {
  const Clock::time_point now = Clock::now();
  steps_.push_back({step, std::chrono::duration<double>(now - last_).count()});
  last_ = now;
}

void Laps::end(const std::vector<StageTiming>& steps) {
  steps_.insert(steps_.end(), steps.begin(), steps.end());
  last_ = Clock::now();
}

std::string Laps::table(const std::string& title) const {
  std::string table = printable(title) + ":\n";
  double total = 0;
  for (const StageTiming& step : steps_) {
    table += formatted("  %-20s %10.2f ms\n", step.stage.c_str(), 1e3 * step.seconds);
    total += step.seconds;
  }
  return table + formatted("  %-20s %10.2f ms\n", "total", 1e3 * total);
}

}  // namespace roomgraph
