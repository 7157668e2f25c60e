#include "roomgraph/report/comparison_sentences.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** How a list of maps that break goes on: which break moves most. */
std::string largestBreak(const Comparison& comparison) {
  const auto isSlight = [](const MapBreak& one) { return one.kind() == BreakClass::slight; };
  const std::vector<MapBreak>& breaks = comparison.breaks;  // the largest first
  const MapBreak& largest = *std::find_if_not(breaks.begin(), breaks.end(), isSlight);
  const bool isOnly = countIf(breaks, isSlight) + 1 == breaks.size();
  std::string text = isOnly ? "," : ". The largest break: " + largest.run;
  if (largest.keyFrame) text += " from key frame " + std::to_string(*largest.keyFrame) + " on,";
  if (text.back() != ',') text += ",";
  return text + formatted(" by %.1f degrees and %.2f m.", std::abs(largest.rotation) * 180 / M_PI,
                          largest.shift);
}

/** With two digits, and as far below the limit as these can tell. */
std::string unsureText(double confidence) {
  return formatted("%.2f", std::min(confidence, kSureConfidence - 0.01));
}

/** What a gate says, "run: what" in each line, with each run named once. */
std::string reasonsOf(const GateVerdict& gate) {
  std::vector<std::string> lines = gate.isPassed() ? gate.margins : gate.complaints;
  std::string last;
  for (std::string& line : lines) {
    const std::size_t colon = line.find(": ");
    const std::string run = colon == std::string::npos ? "" : line.substr(0, colon + 2);
    if (run == last) line.erase(0, run.size());
    last = run;
  }
  return listedSentences(std::move(lines), kMostNames);
}

}  // namespace

std::string breaksSentence(const Comparison& comparison) {
  std::size_t slight = comparison.breaks.size();
  std::vector<std::string> names;
  for (const ComparedRun& run : comparison.runs) {
    const std::size_t count = comparison.countBreaks(run.name);
    if (count == 0) continue;
    slight -= count;
    std::string more = count > 1 ? std::to_string(count) + " places" : "";
    if (comparison.isPlaceDoubtful(run.name))
      more += more.empty() ? "position doubtful" : ", position doubtful";
    names.push_back(run.name + (more.empty() ? "" : " (" + more + ")"));
  }
  const std::string more = counted(slight, "slight break is", "slight breaks are") + " listed";
  if (names.empty()) return slight > 0 ? "No map breaks; " + more + "." : "";
  return counted(names.size(), "map breaks", "maps break") + ": " + listed(names, kMostNames) +
         largestBreak(comparison) + (slight > 0 ? " " + more + ", too." : "");
}

std::string refutedSentence(const Comparison& comparison) {
  std::vector<std::string> lines;
  for (const ComparedRun& run : comparison.runs)
    if (run.welded) lines.push_back(run.name + " " + run.unconfirmedFault());
  return lines.empty() ? "" : listedSentences(std::move(lines), kMostNames) + ".";
}

std::string doubtSentence(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const ComparedPair& pair : comparison.pairs)
    if (comparison.hasBoth(pair) && pair.isSameSite && pair.confidence < kSureConfidence)
      names.push_back(pair.a + " on " + pair.b + " (" + unsureText(pair.confidence) + ")");
  if (names.empty()) return "";
  return counted(names.size(), "pair was", "pairs were") + " aligned with a confidence below " +
         formatted("%.1f", kSureConfidence) + ": check " + listed(names, kMostNames) + ".";
}

std::string gateSentence(const GateVerdict& gate) {
  const std::string judged =
      gate.candidates.empty() ? "" : " of " + listed(gate.candidates, kMostNames);
  const std::string asked = gate.asked.empty() ? "" : " (" + listed(gate.asked, kMostNames) + ")";
  const std::string reasons = reasonsOf(gate);
  return "The gate" + judged + (gate.isPassed() ? " passes" : " fails") + asked +
         (reasons.empty() ? "" : ": " + reasons) + ".";
}

std::string gateLine(const GateVerdict& gate) {
  const std::string reasons = reasonsOf(gate);
  const std::string text = reasons.empty() ? listed(gate.candidates, kMostNames) : reasons;
  return std::string(gate.isPassed() ? "PASS" : "FAIL") + (text.empty() ? "" : " " + text);
}

}  // namespace roomgraph
