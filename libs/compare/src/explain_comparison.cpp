#include "explain_comparison.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace roomgraph {
namespace {

constexpr double kLittle = 0.6;  // share of the walls below which a bend tells little

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/** What speaks against a run, in the order of its weight in the score. */
std::string against(const ComparedRun& run, const std::vector<MapBreak>& breaks) {
  const RunScore& score = *run.score;
  std::string text = formatted("bends %.2f m away from the %zu other %s", score.bend, score.others,
                               score.others == 1 ? "run" : "runs");
  if (score.share < kLittle)
    text += formatted(" as far as they have its walls (%.0f %%)", 100 * score.share);
  const auto isOfRun = [&](const MapBreak& found) { return found.run == run.name; };
  if (const auto count = std::count_if(breaks.begin(), breaks.end(), isOfRun))
    text += formatted(", breaks in %ld place%s", long(count), count == 1 ? "" : "s");
  if (const Measure* deviation = find(run.measures, "axis_deviation");
      deviation && deviation->value)
    text += formatted(", walls %.1f degrees off right angles", *deviation->value);
  if (!score.isMeaningful) text += "; too little to judge by";
  return text;
}

std::optional<double> coverageOf(const ComparedRun& run) {
  const Measure* coverage = find(run.measures, "coverage");
  return coverage && coverage->isMeaningful ? coverage->value : std::nullopt;
}

}  // namespace

std::string reasonOf(const ComparedRun& run, const Comparison& comparison) {
  std::string reason = run.score                          ? against(run, comparison.breaks)
                       : comparison.reference == run.name ? "the others are measured against it"
                                                          : "no other run to compare it with";
  if (run.isScaleEstimated) reason += formatted("; %.4f m per cell, estimated", run.resolution);
  return reason;
}

std::string verdictOf(const Comparison& result) {
  if (result.runs.size() < 2)
    return "Fewer than two runs of one site are left: nothing can be compared.";
  const ComparedRun &best = result.runs[0], &next = result.runs[1];
  if (!best.score) return "The runs share no walls: nothing can be compared.";
  if (!result.reference && result.runs.size() == 2)
    return formatted("Two runs cannot tell for sure which is better: they bend %.2f m apart.",
                     best.score->bend);
  std::string text =
      best.name + formatted(
                      " is the best map, with score %.1f (%.1f to %.1f) and a map error of "
                      "about %.2f m",
                      best.score->score, best.score->low, best.score->high, best.score->mapError);
  if (next.score && next.score->high >= best.score->low)
    text += "; " + next.name + " may be as good";
  if (const auto coverage = coverageOf(best); coverage && *coverage < kPartialCoverage)
    text += formatted("; it has seen %.0f %% of what two runs have seen", 100 * *coverage);
  if (!best.score->isMeaningful) text += ", but there is too little to judge by";
  return text + ".";
}

}  // namespace roomgraph
