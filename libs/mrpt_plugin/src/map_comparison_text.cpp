#include "roomgraph/mrpt_plugin/map_comparison_text.h"

#include <cmath>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/report/comparison_json.h"

namespace roomgraph {
namespace {

std::string breakLine(const MapBreak& tear, bool isDoubtful) {
  std::string line = "  " + tear.run +
                     formatted(" at (%.2f, %.2f) m, by %.1f deg and %.2f m", tear.place.x,
                               tear.place.y, tear.rotation * 180 / M_PI, tear.shift);
  if (tear.keyFrame) line += ", from key frame " + std::to_string(*tear.keyFrame) + " on";
  if (tear.time) line += ", " + timeText(*tear.time);
  return line + (isDoubtful ? ", doubtful\n" : "\n");
}

}  // namespace

std::string mapComparisonText(const Comparison& comparison) {
  std::string text = comparison.verdict + "\n\n" + comparisonText(comparison);
  if (!comparison.breaks.empty()) text += "\nBreaks\n";
  for (const MapBreak& tear : comparison.breaks)
    text += breakLine(tear, comparison.isPlaceDoubtful(tear.run));
  return text;
}

}  // namespace roomgraph
