#include "roomgraph/archive/choose_record.h"

#include <algorithm>
#include <optional>

namespace roomgraph {
namespace {

// Rooms change over years, so the best of all times is no judge; nor are the files of years asked
// for.
constexpr std::size_t kLast = 100;

/** Fills a list of runs, each once, up to a number. */
class Choice {
 public:
  Choice(const std::vector<HistoryRun>& runs,
         const std::function<bool(const HistoryRun&)>& isUsable)
      : runs_(runs), isUsable_(isUsable), states_(runs.size()) {}

  void fill(const std::vector<std::size_t>& candidates, std::size_t upTo) {
    for (const std::size_t i : candidates) {
      if (chosen_.size() >= upTo) return;
      if (states_[i]) continue;
      states_[i] = isUsable_(runs_[i]);
      if (*states_[i]) chosen_.push_back(i);
    }
  }

  std::size_t count() const { return chosen_.size(); }

  std::vector<std::size_t> inOrder() {
    std::sort(chosen_.begin(), chosen_.end());
    return chosen_;
  }

 private:
  const std::vector<HistoryRun>& runs_;
  const std::function<bool(const HistoryRun&)>& isUsable_;
  std::vector<std::optional<bool>> states_;  // whether it is usable; none where nobody has asked
  std::vector<std::size_t> chosen_;
};

}  // namespace

std::vector<std::size_t> chooseRecord(const std::vector<HistoryRun>& runs, std::size_t most,
                                      const std::function<bool(const HistoryRun&)>& isUsable) {
  std::vector<std::size_t> latest, best, elsewhere;
  std::size_t since = 0;
  for (std::size_t i = runs.size(); i-- > 0 && latest.size() < kLast;) {
    (runs[i].isPlaced ? latest : elsewhere).push_back(i);
    if (latest.empty()) ++since;
  }
  if (elsewhere.size() < latest.size()) elsewhere.resize(since);
  for (const std::size_t i : latest)
    if (trustedFigure(runs[i], kMapError) && figureOf(runs[i], kBreaks).value_or(0) == 0)
      best.push_back(i);
  const auto errorOf = [&](std::size_t i) { return *trustedFigure(runs[i], kMapError); };
  std::stable_sort(best.begin(), best.end(),
                   [&](std::size_t l, std::size_t r) { return errorOf(l) < errorOf(r); });
  Choice choice(runs, isUsable);
  choice.fill(elsewhere, (most + 2) / 3);
  choice.fill(latest, (choice.count() + most) / 2);
  choice.fill(best, most);
  choice.fill(latest, most);
  return choice.inOrder();
}

}  // namespace roomgraph
