#include "explain_comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr double kWorthAWord = 0.05;  // share that no other run bears out

/** What decided the score of a run. */
std::string decisive(const ComparedRun& run, const Comparison& comparison) {
  const RunScore& score = *run.score;
  std::string text = formatted("its walls lie %.2f m RMS from ", rounded(score.mapError));
  text += comparison.reference ? "the reference"
          : comparison.core.empty()
              ? "the consensus of " + counted(score.others + 1, "run", "runs")
              : formatted("the consensus of the core of %zu runs", comparison.core.size());
  if (const std::size_t count = comparison.countBreaks(run.name))
    text += formatted("; it breaks in %zu place%s", count, count == 1 ? "" : "s");
  if (score.scale != 1 && !score.isScaleDisputed)
    text += formatted("; it is %.1f %% too %s", 100 * std::abs(score.scale - 1),
                      score.scale > 1 ? "large" : "small");
  if (score.jitter > 0)
    text +=
        formatted("; its key frames are off by %.2f m, independently of each other", score.jitter);
  if (comparison.isPlaceDoubtful(run.name))
    text += "; doubtful, as no reliable alignment links it to most of the others";
  if (score.share < kNearlyAll)
    text +=
        formatted("; only %.0f %% of its walls were found in the other maps", 100 * score.share);
  if (score.contradicted > 0)
    text += formatted("; others contradict %.0f %% of what it has drawn, and show it nowhere else",
                      std::max(1.0, 100 * score.contradicted));
  if (score.confirmed < 1 - score.contradicted - kWorthAWord)
    text += formatted("; %.0f %% of what it has drawn no other run confirms",
                      100 * (1 - score.confirmed));
  if (const Measure* added = run.addedWalls())
    text += formatted("; round (%.1f, %.1f) %.0f %% of its walls %s in free space of the others",
                      added->place->x, added->place->y, 100 * *added->value,
                      added->name == "walls_added" ? "stand" : "are straight and stand");
  if (const std::string fault = comparison.faultOfReference(run); !fault.empty())
    text += "; " + fault;
  else if (!score.isMeaningful && run.unconfirmedFault().empty())
    text += "; too little to judge by";
  return text;
}

/** The map error of a run that has one; errors of less than 0.05 m can hardly be told apart. */
std::string errorText(const ComparedRun& run) {
  const double error = run.score->mapError;
  return error < 0.005 ? "less than 0.05 m" : formatted("about %.2f m", rounded(error));
}

/** Whether its interval ends above the score of at least one other run. */
bool isBetterThanAny(const ComparedRun& best, const Comparison& comparison) {
  return anyOf(comparison.runs, [&](const ComparedRun& run) {
    return run.name != best.name && (!run.score || run.score->score < best.score->low);
  });
}

/** The run that a run is a later copy of. */
std::optional<std::string> originalOf(const std::string& run, const Comparison& comparison) {
  for (const std::vector<std::string>& names : comparison.copies())
    if (names.front() != run && contains(names, run)) return names.front();
  return {};
}

/** The others whose intervals reach up to that of the run with the smallest error, which are
 *  no more doubtful, and of which nothing speaks against the whole. */
std::vector<std::string> rivalsOf(const ComparedRun& best, const Comparison& comparison) {
  std::vector<std::string> rivals;
  const Certainty least = std::max(Certainty::likely, comparison.certaintyOf(best));
  for (const ComparedRun& run : comparison.runs)
    if (run.name != best.name && run.isBorneOut() && run.score->isMeaningful &&
        comparison.certaintyOf(run) <= least && run.score->high >= best.score->low)
      rivals.push_back(run.name);
  return rivals;
}

/** Whether another run, of which nothing can be told, seems to be better. */
bool seemsOutdone(const ComparedRun& best, const Comparison& comparison) {
  return anyOf(comparison.runs, [&](const ComparedRun& run) {
    return run.score && !run.score->isMeaningful && run.score->mapError < best.score->mapError;
  });
}

/** Whether all but one or two of the runs are edits of these, which say nothing more. */
bool isAlmostAlone(const Comparison& comparison) {
  std::size_t independent = comparison.runs.size();
  for (const std::vector<std::string>& names : comparison.edits()) independent -= names.size() - 1;
  return !comparison.reference && independent < 3;
}

/** What the run with the smallest error "has" or "is" that speaks against it. */
std::vector<std::string> doubtsAbout(const ComparedRun& best, const Comparison& comparison) {
  std::vector<std::string> doubts;
  if (const auto coverage = best.partialCoverage())
    doubts.push_back(formatted("has seen only %.0f %% of what at least two runs have seen",
                               100 * rounded(*coverage)));
  if (comparison.isPlaceDoubtful(best.name))
    doubts.push_back("has no reliable alignment to most of the others");
  if (const Measure* added = best.addedWalls())
    doubts.push_back(formatted("has a place where others show no such walls, round (%.1f, %.1f)",
                               added->place->x, added->place->y));
  if (const std::string fault = best.unconfirmedFault(); !fault.empty()) doubts.push_back(fault);
  if (const std::string fault = comparison.faultOfReference(best); !fault.empty())
    doubts.push_back("cannot be measured (" + fault + ")");
  else if (!best.score->isMeaningful && best.unconfirmedFault().empty())
    doubts.emplace_back(
        isAlmostAlone(comparison)
            ? "can be compared with one other map at most, as the rest are copies or edits"
            : "has too little to judge by");
  return doubts;
}

}  // namespace

std::string reasonOf(const ComparedRun& run, const Comparison& comparison) {
  std::string reason = run.score                          ? decisive(run, comparison)
                       : run.welded                       ? "it " + run.unconfirmedFault()
                       : comparison.reference == run.name ? "the others are measured against it"
                       : comparison.runs.size() < 2
                           ? "no other run to compare it with"
                           : "none of its walls could be followed in another run";
  if (const auto original = originalOf(run.name, comparison)) reason += "; a copy of " + *original;
  if (run.isScaleEstimated) reason += formatted("; %.4f m per cell, estimated", run.resolution);
  return reason;
}

std::string verdictOf(const Comparison& result) {
  if (result.runs.size() < 2)
    return "Fewer than two runs of one site are left: nothing can be compared.";
  if (!result.reference && result.areCopies())
    return (result.runs.size() == 2 ? "Both" : formatted("All %zu", result.runs.size())) +
           " runs are copies of one file, which say nothing about each other.";
  const ComparedRun& best = result.runs[0];
  if (!best.score)
    return "The runs lie in one site, but no walls could be followed from one to another: nothing "
           "can be compared.";
  if (!result.reference && result.runs.size() == 2)
    return formatted("Two runs cannot tell for sure which is better: they bend %.2f m apart.",
                     valueOf(best.measures, "bend").value_or(0));
  const std::vector<std::string> doubts = doubtsAbout(best, result);
  if (!best.score->isMeaningful)
    return "No run can be judged: " + best.name + ", with the smallest error (" + errorText(best) +
           "), " + listed(doubts) + ".";
  if (result.reference && result.runs.size() == 2)
    return best.name + " is " + errorText(best) + " off the reference" +
           formatted(" (%.2f to %.2f m).", rounded(best.score->errorLow),
                     rounded(best.score->errorHigh)) +
           (doubts.empty() ? "" : " But it " + listed(doubts) + ".");
  const bool isOutdone = seemsOutdone(best, result);
  const bool isBest =
      result.certaintyOf(best) == Certainty::sure && !isOutdone && isBetterThanAny(best, result);
  std::string text =
      best.name +
      (isBest      ? " is the best map"
       : isOutdone ? " has the smallest error of those that can be judged"
                   : " has the smallest error") +
      // Of the figures as comparison.json holds them, from which others are made.
      formatted(", with score %.1f (%.1f to %.1f) and a map error of ", rounded(best.score->score),
                rounded(best.score->low), rounded(best.score->high)) +
      errorText(best);
  const std::vector<std::string> rivals = rivalsOf(best, result);
  if (!rivals.empty()) text += "; " + listed(rivals, 4) + " may be as good";
  return text + "." + (doubts.empty() ? "" : " But " + best.name + " " + listed(doubts) + ".");
}

std::string copiesNote(const Comparison& comparison) {
  if (comparison.areCopies()) return "";  // which is the verdict already
  std::string text;
  const auto copies = comparison.copies(), edits = comparison.edits();
  for (const std::vector<std::string>& names : copies) {
    const std::vector<std::string> later(names.begin() + 1, names.end());
    text += " " + listed(later) + (later.size() == 1 ? " is a copy of " : " are copies of ") +
            names.front() + ".";
  }
  for (const std::vector<std::string>& names : edits)
    if (!contains(copies, names))
      text += formatted(" %zu maps are edits of one (", names.size()) + listed(names) +
              "), and count as one drive.";
  return text;
}

std::string scalesNote(const std::vector<std::string>& larger,
                       const std::vector<std::string>& smaller, double ratio) {
  return " " + listed(larger) + (larger.size() == 1 ? " is" : " are") +
         formatted(" %.1f %% larger than ", 100 * (ratio - 1)) + listed(smaller) +
         "; the runs cannot show which scale is right, but a floor plan as --reference can.";
}

std::string otherSitesNote(const std::vector<std::vector<std::string>>& sites) {
  std::string text =
      formatted(" There are %zu sites, of which this compares the first: ", sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    text += (i == 0 ? "{" : ", {") + listed(sites[i]) + "}";
  return text + ".";
}

std::string sharedDriveNote(const std::vector<std::string>& names, std::size_t runsOfSite) {
  const bool areAll = names.size() == runsOfSite;
  return (areAll && names.size() == 2
              ? " Both runs"
              : formatted(" %s%zu runs", areAll ? "All " : "", names.size())) +
         " are of one drive" + (areAll ? "" : " (" + listed(names) + ")") +
         "; errors that they share cannot be detected.";
}

std::string unknownDrivesNote(std::size_t runsWithoutScans, std::size_t runsOfSite) {
  return formatted(
      " %s without scans, so whether they are of one drive is unknown; errors that runs of one "
      "drive share cannot be detected.",
      runsWithoutScans == runsOfSite ? "All maps are"
                                     : formatted("%zu maps are", runsWithoutScans).c_str());
}

std::string usualScaleNote(const Comparison& comparison) {
  if (!comparison.isScaleUsual()) return "";
  const double resolution = comparison.runs[0].resolution;
  return formatted(
      " No map tells the scale: %.2g m per cell is taken, as usual in buildings, so an error of "
      "0.10 m stands for %.2g cells, and the true scale may be half or twice as large.",
      resolution, 0.1 / resolution);
}

}  // namespace roomgraph
