#include "roomgraph/compare/gate.h"

#include <cmath>
#include <cstdio>

namespace roomgraph {
namespace {

std::string breakText(const MapBreak& found) {
  char text[100];
  std::snprintf(text, sizeof text, "is broken at (%.1f, %.1f) by %.1f degrees and %.2f m",
                found.place.x, found.place.y, found.rotation * 180 / M_PI, found.shift);
  return text;
}

std::string coverageText() {
  const int percent = int(std::lround(100 * kPartialCoverage));
  return "has seen less than " + std::to_string(percent) + " % of what two runs have seen";
}

}  // namespace

GateVerdict gateVerdict(const Comparison& comparison, const GateOptions& options) {
  std::vector<std::string> lines;
  for (const ComparedRun& run : comparison.runs) {
    if (run.name == comparison.reference) continue;
    if (options.minScore && !run.score) lines.push_back(run.name + ": has no score");
    if (options.minScore && run.score && run.score->score < *options.minScore)
      lines.push_back(run.name + ": its score is below --fail-below");
    const Measure* coverage = find(run.measures, "coverage");
    if (options.failsOnCoverage && coverage && coverage->value.value_or(0) < kPartialCoverage)
      lines.push_back(run.name + ": " + coverageText());
  }
  for (const MapBreak& found : comparison.breaks)
    if (options.failsOnBreaks) lines.push_back(found.run + ": " + breakText(found));
  for (const LeftOutRun& run : comparison.leftOut) {
    if (options.minScore) lines.push_back(run.name + ": has no score");
    if (run.isOtherSite && options.failsOnOtherSites)
      lines.push_back(run.name + ": is not of the same site");
  }
  return {lines};
}

}  // namespace roomgraph
