#include "navigation_word.h"

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
  return "perhaps: a slow bend does no harm to a localisation that corrects itself, a bend in one "
         "place does";
}

/** Where the best run breaks: the best one without a break, of which all can be told. */
std::string toDrive(const Comparison& comparison) {
  for (const ComparedRun& run : comparison.runs)
    if (comparison.certaintyOf(run) <= Certainty::likely && run.score->isBorneOut() &&
        run.score->jitter < kSmeared && comparison.countBreaks(run.name) == 0)
      return " To drive: " + run.name + ", which has no break, and " + errorText(*run.score) +
             "; to measure: " + comparison.runs[0].name + ".";
  return "";
}

}  // namespace

std::string navigationWord(const Comparison& comparison) {
  if (comparison.runs.empty() || !comparison.runs[0].score || comparison.runs[0].rank == 0)
    return "";
  const ComparedRun& best = comparison.runs[0];
  const std::string start = "Navigation with " + best.name + ": ";
  const Certainty certainty = comparison.certaintyOf(best);
  if (certainty == Certainty::cannotTell)
    return start + "cannot be told, there is too little to judge by.";
  if (certainty == Certainty::doubtful)
    return start + "cannot be told, no pair that is sure joins it to most of the others.";
  if (comparison.countBreaks(best.name) > 0)
    return start +
           "not good enough. It breaks, and a robot that drives across a break is lost for a "
           "moment." +
           toDrive(comparison);
  if (best.score->jitter >= kSmeared)
    return start +
           "not good enough. Its key frames lie off each on its own, which smears its walls.";
  if (!best.score->isBorneOut())
    return start + "cannot be told, too much of it is borne out by no other run.";
  return start + wordFor(*best.score) + ". It has no break, and " + errorText(*best.score) + ".";
}

}  // namespace roomgraph
