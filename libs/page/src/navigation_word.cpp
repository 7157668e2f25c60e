#include "navigation_word.h"

#include <algorithm>

#include "page_data.h"

namespace roomgraph {
namespace {

// As docs/scoring.md has them [m].
constexpr double kForSharedPlaces = 0.1, kForLengths = 0.3;

std::string errorText(const RunScore& score) {
  return "its map error is about " + fixedText(score.mapError, 2) +
         " m, and most likely no more than " + fixedText(score.errorHigh, 2) + " m";
}

/** For a map without a break. */
std::string wordFor(const RunScore& score) {
  if (score.errorHigh <= kForSharedPlaces)
    return "good enough, also for docking, and for goals and zones that robots share";
  if (score.mapError <= kForSharedPlaces)
    return "good enough with a localisation that corrects itself; probably also for docking, and "
           "for goals and zones that robots share";
  if (score.mapError <= kForLengths)
    return "good enough with a localisation that corrects itself, and for lengths and areas; not "
           "for docking, or goals and zones that robots share";
  return "doubtful: a slow bend does no harm to a localisation that corrects itself, a bend in one "
         "place does";
}

}  // namespace

std::string navigationWord(const Comparison& comparison) {
  if (comparison.runs.empty() || !comparison.runs[0].score || comparison.runs[0].rank == 0)
    return "";
  const ComparedRun& best = comparison.runs[0];
  const std::string start = "Navigation with " + best.name + ": ";
  if (!best.score->isMeaningful) return start + "cannot be told, there is too little to judge by.";
  if (comparison.isPlaceDoubtful(best.name))
    return start + "cannot be told, most of its pairs are aligned with little confidence.";
  const auto breaks = std::count_if(comparison.breaks.begin(), comparison.breaks.end(),
                                    [&](const MapBreak& tear) { return tear.run == best.name; });
  if (breaks > 0)
    return start +
           "not good enough. It breaks, and a robot that drives across a break is lost for a " +
           "moment.";
  return start + wordFor(*best.score) + ". It has no break, and " + errorText(*best.score) + ".";
}

}  // namespace roomgraph
