#include "page_summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "navigation_word.h"
#include "page_data.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMostNames = 4;

/** Which break moves most, where there are several: the first one. */
std::string largestBreak(const Comparison& comparison) {
  if (comparison.breaks.size() < 2) return "";
  const MapBreak& largest = comparison.breaks.front();
  std::string text = " The largest break: " + largest.run;
  if (largest.keyFrame) text += " from key frame " + std::to_string(*largest.keyFrame) + " on";
  return text + ", by " + fixedText(std::abs(largest.rotation) * 180 / M_PI, 1) + "° and " +
         fixedText(largest.shift, 2) + " m.";
}

std::string breaksSentence(const Comparison& comparison) {
  std::map<std::string, std::size_t> breaks;
  for (const MapBreak& tear : comparison.breaks) ++breaks[tear.run];
  std::vector<std::string> names;
  for (const ComparedRun& run : comparison.runs)
    if (breaks.count(run.name)) {
      std::vector<std::string> more;
      if (breaks[run.name] > 1) more.push_back(std::to_string(breaks[run.name]) + " places");
      if (comparison.isPlaceDoubtful(run.name)) more.emplace_back("doubtful");
      names.push_back(run.name + (more.empty() ? "" : " (" + listed(more) + ")"));
    }
  return counted(names.size(), "map is torn", "maps are torn") + ": " + listed(names, kMostNames) +
         "." + largestBreak(comparison);
}

std::string goneSentence(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const SiteRoom& room : comparison.rooms) {
    std::vector<std::string> runs;
    for (const RoomInRun& one : room.runs)
      if (one.sighting == RoomSighting::gone) runs.push_back(one.run);
    if (!runs.empty()) names.push_back(room.name + " in " + listed(runs, kMostNames));
  }
  if (names.empty()) return "";
  return counted(names.size(), "room is", "rooms are") +
         " missing where a run has looked: " + listed(names, kMostNames) + ".";
}

std::string gateSentence(const GateVerdict& gate) {
  const std::string judged =
      gate.candidates.empty() ? "" : " of " + listed(gate.candidates, kMostNames);
  const std::string asked = gate.asked.empty() ? "" : " (" + listed(gate.asked, kMostNames) + ")";
  if (gate.isPassed()) return "The gate" + judged + " passes" + asked + ".";
  return "The gate" + judged + " fails" + asked + ": " + listed(gate.complaints, kMostNames) + ".";
}

std::string doubtSentence(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const ComparedPair& pair : comparison.pairs)
    if (pair.isSameSite && pair.confidence < kSureConfidence)
      names.push_back(pair.a + " on " + pair.b + " (" + fixedText(pair.confidence, 2) + ")");
  if (names.empty()) return "";
  return counted(names.size(), "pair was", "pairs were") + " aligned with a confidence below " +
         fixedText(kSureConfidence, 1) + ": check " + listed(names, kMostNames) + ".";
}

/** Not those with a run that is left out. */
std::size_t pairsOfSite(const Comparison& comparison) {
  std::set<std::string> names;
  for (const ComparedRun& run : comparison.runs) names.insert(run.name);
  return std::size_t(std::count_if(
      comparison.pairs.begin(), comparison.pairs.end(),
      [&](const ComparedPair& pair) { return names.count(pair.a) && names.count(pair.b); }));
}

}  // namespace

std::string pageCounts(const Comparison& comparison) {
  std::string text = counted(comparison.runs.size(), "run", "runs") + " of one site, " +
                     counted(pairsOfSite(comparison), "pair", "pairs");
  if (!comparison.rooms.empty())
    text += ", " + counted(comparison.rooms.size(), "room", "rooms and corridors");
  return text;
}

std::vector<std::string> pageSummary(const Comparison& comparison) {
  std::vector<std::string> sentences;
  const std::string navigation = navigationWord(comparison);
  if (!navigation.empty()) sentences.push_back(navigation);
  if (comparison.gate) sentences.push_back(gateSentence(*comparison.gate));
  if (!comparison.runs.empty() && comparison.runs[0].score && comparison.runs.size() > 2)
    sentences.push_back("Why " + comparison.runs[0].name + ": " + comparison.runs[0].reason + ".");
  if (comparison.reference)
    sentences.push_back("All runs are measured against " + *comparison.reference + ".");
  if (!comparison.core.empty())
    sentences.push_back("The consensus is that of " +
                        counted(comparison.core.size(), "run", "runs") +
                        ", the core; each other run is held against it.");
  if (!comparison.breaks.empty()) sentences.push_back(breaksSentence(comparison));
  const std::string gone = goneSentence(comparison);
  if (!gone.empty()) sentences.push_back(gone);
  const std::string doubt = doubtSentence(comparison);
  if (!doubt.empty()) sentences.push_back(doubt);
  if (!comparison.leftOut.empty()) {
    std::vector<std::string> names;
    for (const LeftOutRun& run : comparison.leftOut) names.push_back(run.name);
    sentences.push_back(counted(names.size(), "file is", "files are") +
                        " left out: " + listed(names, kMostNames) + ".");
  }
  return sentences;
}

}  // namespace roomgraph
