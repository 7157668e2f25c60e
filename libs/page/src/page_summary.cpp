#include "page_summary.h"

#include <algorithm>
#include <set>

#include "navigation_word.h"
#include "page_data.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/report/comparison_sentences.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMostNames = 4;

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
  const std::string breaks = breaksSentence(comparison);
  if (!breaks.empty()) sentences.push_back(breaks);
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
