#include "site_runs.h"

#include <memory>

#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/relate/place_runs.h"
#include "roomgraph/repair/solve_runs.h"
#include "roomgraph/report/PairFolder.h"
#include "roomgraph/report/comparison_sentences.h"
#include "run_in_order.h"
#include "terminal.h"

namespace roomgraph {
namespace {

/** Runs are to bear each other out, which a copy does not; the reference stays. */
void leaveOutCopies(ReadRuns& read) {
  std::vector<Run>& runs = read.runs;
  for (std::size_t i = runs.size(); i-- > 0;) {
    const auto isOriginal = [&](const Run& other) {
      const auto place = std::size_t(&other - runs.data());
      return (place < i || read.reference == place) && other.sha256 == runs[i].sha256;
    };
    const Run* original = findIf(runs, isOriginal);
    if (!original || read.reference == i) continue;
    if (runs[i].file != original->file)
      printError(runs[i].file + ": is a copy of " + original->file + ": left out");
    if (read.reference && *read.reference > i) --*read.reference;
    runs.erase(runs.begin() + std::ptrdiff_t(i));
  }
}

/** Names what does not lie in the site. */
void printOthers(const SolvedRuns& runs) {
  for (std::size_t i = 0; i < runs.read.runs.size(); ++i)
    if (!runs.solved.site.has(i))
      printError(runs.read.runs[i].file + ": does not lie in the site of the others: left out");
}

/** Says that the others follow a reference that breaks itself, as far as its scans tell. */
void printFaultOf(const Run& reference) {
  const RunCheck check = checkRun(reference);
  if (!check.breaks.empty() && check.breaks.front().torn)
    printError(
        reference.file +
        formatted(": the reference breaks at key frame %zu, so the others are bent to follow "
                  "it: see 'roomgraph check'",
                  check.breaks.front().keyFrame.value_or(0)));
}

}  // namespace

CompareMapsOptions siteOptions(const SiteArguments& arguments) {
  CompareMapsOptions options = toCompareOptions(arguments.options);
  options.reference = arguments.reference;
  options.compare.forEach = onThreads(arguments.running.threads, !arguments.running.isQuiet);
  options.onUnread = [needed = arguments.needed](const LeftOutRun& run) {
    const std::string line = run.file + ": " + run.reason;
    if (contains(needed, run.file)) throw DataError(line);
    printError(line);
  };
  return options;
}

void declareSite(SiteArguments& arguments, const std::string& results, CLI::App& app) {
  declareOutput(arguments.folder, results, app);
  addOption(app, "--reference MAP", arguments.reference,
            "Take this map for the truth: it stays as it is, and the others follow it.");
  addOption(app, "--cache DIR", arguments.cache,
            "Folder that keeps what was found for each pair of maps, as for 'roomgraph "
            "compare'.");
  declareThreads(arguments.running.threads, "maps or pairs", app);
  declareQuiet(arguments.running.isQuiet, app);
  declareOptions(arguments.options, app);
}

std::unique_ptr<SolvedRuns> solvedRunsOf(const SiteArguments& arguments) {
  CompareMapsOptions options = siteOptions(arguments);
  UnusedOptions unused;
  options.onNote = unused.takeOrWarn();
  ReadRuns read = readRuns(arguments.files, options);
  unused.tell(arguments.files.size() + (arguments.reference.empty() ? 0 : 1));
  if (!arguments.takesCopies) leaveOutCopies(read);
  options.compare.reference = read.reference;
  PairFolder cache(arguments.cache);
  options.compare.kept = cache.kept();
  SolvedSite solved = solveRuns(read.runs, options.compare, arguments.areOneSite);
  if (!cache.failure().empty()) printError(cache.failure());
  // The runs stay where they are: the vector is moved, not what it holds.
  std::unique_ptr<SolvedRuns> runs(new SolvedRuns{std::move(read), std::move(solved)});
  printOthers(*runs);
  if (runs->read.reference) printFaultOf(runs->read.runs[*runs->read.reference]);
  return runs;
}

void printUnplaced(const SolvedRuns& runs) {
  const Site& site = runs.solved.site;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (countSure(runs.solved.pairs, i) == 0) names.push_back(site.runs[i]->name);
  if (!names.empty())
    printError(
        listed(names, kMostNames) +
        formatted(": not aligned with any other run with a confidence of %.1f: in a building "
                  "that repeats itself, this may be the wrong place: check the result",
                  kSureConfidence));
}

}  // namespace roomgraph
