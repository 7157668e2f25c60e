#include "choose_judges.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** Calls with the index in `seen` of each place that both have; both are ascending. */
template <class Call>
void forEachShared(const SeenPlaces& seen, const SeenPlaces& other, const Call& call) {
  for (std::size_t i = 0, j = 0; i < seen.size() && j < other.size();) {
    if (seen[i] == other[j]) call(i);
    if (seen[i] <= other[j])
      ++i;
    else
      ++j;
  }
}

}  // namespace

std::vector<std::size_t> chooseJudges(const SeenPlaces& seen, const std::vector<SeenPlaces>& core,
                                      std::size_t count, std::size_t fixed) {
  std::vector<double> worth(seen.size(), 1);  // of each place
  std::vector<bool> isChosen(core.size());
  std::vector<std::size_t> chosen;
  const auto choose = [&](std::size_t judge) {
    chosen.push_back(judge);
    isChosen[judge] = true;
    forEachShared(seen, core[judge], [&](std::size_t i) { worth[i] /= 2; });
  };
  for (std::size_t i = 0; i < std::min(fixed, core.size()); ++i) choose(i);
  while (chosen.size() < count) {
    double most = 0;
    std::size_t best = 0;
    for (std::size_t judge = 0; judge < core.size(); ++judge) {
      if (isChosen[judge]) continue;
      double sum = 0;
      forEachShared(seen, core[judge], [&](std::size_t i) { sum += worth[i]; });
      if (sum > most) most = sum, best = judge;
    }
    if (most <= 0) break;
    choose(best);
  }
  return chosen;
}

}  // namespace roomgraph
