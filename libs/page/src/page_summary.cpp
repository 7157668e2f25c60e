#include "page_summary.h"

#include <algorithm>
#include <map>

#include "page_data.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/xml_text.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/page/simple_page.h"
#include "roomgraph/report/comparison_sentences.h"

namespace roomgraph {
namespace {

/** In quotes where a shell would take it apart. */
std::string quoted(const std::string& word) {
  const auto isPlain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string("-_./=+:,%@").find(c) != std::string::npos;
  };
  if (!word.empty() && allOf(word, isPlain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/** As an argument; nothing for an option that has its default. */
std::string argumentOf(const UsedOption& option) {
  static const std::map<std::string, std::string> flags = {{"aligned", " --aligned"},
                                                           {"estimate_scale", " --estimate-scale"}};
  if (option.section != "compare")
    return " --set " + quoted(option.section + "." + option.name + "=" + option.value);
  if (option.name == "reference") return " --reference " + quoted(fileName(option.value));
  const auto flag = flags.find(option.name);
  return flag == flags.end() ? "" : flag->second;
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

// As docs/scoring.md has them [m].
constexpr double kForSharedPlaces = 0.1;

std::string errorText(const RunScore& score) {
  return "its map error is about " + fixedText(score.mapError, 2) +
         " m, and most likely no more than " + fixedText(score.errorHigh, 2) + " m";
}

/** For a map without a break. */
std::string wordFor(const RunScore& score, Certainty certainty) {
  if (certainty == Certainty::sure && score.errorHigh <= kForSharedPlaces)
    return "good enough, also for docking, and for goals and zones that robots share";
  if (score.mapError <= kForSharedPlaces)
    return "good enough with a localisation that corrects itself; probably also for docking, and "
           "for goals and zones that robots share";
  if (score.mapError <= 0.3)
    return "good enough with a localisation that corrects itself, and for lengths and areas; not "
           "for docking, or goals and zones that robots share";
  return "perhaps: a slow bend does no harm to a localisation that corrects itself, a bend in one "
         "place does";
}

/** Where the best run breaks: the best one without a break, of which all can be told. */
std::string toDrive(const Comparison& comparison) {
  for (const ComparedRun& run : comparison.runs)
    if (comparison.certaintyOf(run) <= Certainty::likely && run.isBorneOut() &&
        run.score->jitter < kSmeared && comparison.countBreaks(run.name) == 0)
      return " To drive: " + run.name + ", which has no break, and " + errorText(*run.score) +
             "; to measure: " + comparison.runs[0].name + ".";
  return "";
}

}  // namespace

std::string bareReport(const Comparison& comparison) {
  SimplePage page;
  page.title = "Comparison of maps", page.subject = "comparison of maps";
  page.heading = xmlText(pageVerdict(comparison)), page.counts = xmlText(pageCounts(comparison));
  page.body = "<section>\n<ul>\n";
  for (const std::string& sentence : pageSummary(comparison))
    page.body += "<li>" + xmlText(sentence) + "</li>\n";
  page.body += "</ul>\n</section>\n";
  page.footer =
      "It was built without mustache, Leaflet and D3, which draw the maps and tables of this page: "
      "the figures are in comparison.json.";
  return simplePage(page);
}

std::string commandLine(const Comparison& comparison) {
  std::vector<std::string> files;
  for (const ComparedRun& run : comparison.runs)
    if (run.name != comparison.reference) files.push_back(fileName(run.file));
  for (const LeftOutRun& run : comparison.leftOut) files.push_back(fileName(run.file));
  std::sort(files.begin(), files.end());
  std::string text = "roomgraph compare";
  for (const std::string& file : files) text += " " + quoted(file);
  std::map<std::string, std::string> defaults;
  for (const UsedOption& option : usedOptions({}))
    defaults[option.section + "." + option.name] = option.value;
  for (const UsedOption& option : comparison.options) {
    const auto usual = defaults.find(option.section + "." + option.name);
    if (usual == defaults.end() || usual->second != option.value) text += argumentOf(option);
  }
  return text;
}

std::string pageVerdict(const Comparison& comparison) {
  const bool isRefused = comparison.gate && !comparison.gate->isPassed();
  return (isRefused ? "The gate fails. " : "") + comparison.verdict;
}

std::string pageCounts(const Comparison& comparison) {
  const auto pairs =
      countIf(comparison.pairs, [&](const ComparedPair& pair) { return comparison.hasBoth(pair); });
  std::string text = counted(comparison.runs.size(), "run", "runs") + " of one site, " +
                     counted(pairs, "pair", "pairs");
  if (!comparison.rooms.empty())
    text += ", " + counted(comparison.rooms.size(), "room", "rooms and corridors");
  return text;
}

std::vector<std::string> pageSummary(const Comparison& comparison) {
  std::vector<std::string> sentences;
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) sentences.push_back(sentence);
  };
  add(navigationWord(comparison));
  if (comparison.gate) sentences.push_back(gateSentence(*comparison.gate));
  if (!comparison.runs.empty() && comparison.runs[0].score && comparison.runs.size() > 2)
    sentences.push_back("Why " + comparison.runs[0].name + ": " + comparison.runs[0].reason + ".");
  if (comparison.reference)
    sentences.push_back("All runs are measured against " + *comparison.reference + ".");
  if (!comparison.core.empty())
    sentences.push_back("The consensus is that of " +
                        counted(comparison.core.size(), "run", "runs") +
                        ", the core; each other run is held against it.");
  add(refutedSentence(comparison));
  add(breaksSentence(comparison));
  add(goneSentence(comparison));
  add(doubtSentence(comparison));
  if (!comparison.leftOut.empty()) {
    const auto names = mapped(comparison.leftOut, &LeftOutRun::name);
    sentences.push_back(counted(names.size(), "file is", "files are") +
                        " left out: " + listed(names, kMostNames) + ".");
  }
  return sentences;
}

std::string navigationWord(const Comparison& comparison) {
  if (comparison.runs.empty() || !comparison.runs[0].score || comparison.runs[0].rank == 0)
    return "";
  const ComparedRun& best = comparison.runs[0];
  const std::string start = "Navigation with " + best.name + ": ";
  const Certainty certainty = comparison.certaintyOf(best);
  if (certainty == Certainty::cannotTell) {
    const std::string fault = comparison.faultOf(best);
    return start + "cannot be told, " +
           (fault.empty() ? "there is too little to judge by" : "as " + fault) + ".";
  }
  if (comparison.isPlaceDoubtful(best.name))
    return start + "cannot be told, as no reliable alignment links it to most of the others.";
  if (comparison.isScaleUsual())
    return start + "cannot be told in metres, as no map tells its scale.";
  if (comparison.countBreaks(best.name) > 0)
    return start +
           "not good enough. It breaks, and a robot that drives across a break is lost for a "
           "moment." +
           toDrive(comparison);
  if (best.score->jitter >= kSmeared)
    return start +
           "not good enough. Its key frames are off independently of each other, which smears its "
           "walls.";
  if (!best.isBorneOut())
    return start + "cannot be told, not all of it is confirmed by other runs.";
  return start + wordFor(*best.score, certainty) + ". It has no break, and " +
         errorText(*best.score) + ".";
}

}  // namespace roomgraph
