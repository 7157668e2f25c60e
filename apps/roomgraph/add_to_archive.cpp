#include "add_to_archive.h"

#include <filesystem>
#include <set>

#include "output_names.h"
#include "roomgraph/archive/record_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_sha256.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/repair/repair_site.h"
#include "roomgraph/report/PairFolder.h"
#include "run_in_order.h"
#include "site_runs.h"
#include "terminal.h"

namespace roomgraph {
namespace {

constexpr std::size_t kLongestName = 200;  // of a robot or a site [bytes]

std::string lineOf(const std::string& file, const AddedRun& run) {
  std::string text = printable(file) + ": ";
  if (run.wasKnown) return text + "is known already\n";
  if (run.score && run.score->isMeaningful) {
    text += formatted("map error %.3f m, score %.0f: ", run.score->mapError, run.score->score);
  } else if (run.isPlaced) {
    text += "added, not judged yet: ";
  } else {
    text += "added as a run of another site: ";
  }
  return text + printable(run.reason) + "\n";
}

std::string missingText(const std::set<std::string>& files) {
  const std::string more =
      files.size() == 1 ? "" : " (and " + std::to_string(files.size() - 1) + " more)";
  return *files.begin() + more +
         ": note: is missing or has changed: not compared with (--keep keeps copies)";
}

std::string writeRepaired(const Run& run, const RepairedRun& repaired) {
  if (repaired.state != RepairState::mended)
    return printable(run.file + ": " + repaired.reason) + "\n";
  const std::string there =
      (std::filesystem::path(run.file).parent_path() / repairedName(run.file)).string();
  writeFileAtomically(there, movedRun(run, repaired).simplemap);
  return printable(there + ": " + repaired.reason) +
         formatted(", moved by up to %.2f m\n", repaired.movedMost);
}

/** Mends the copy of a run that an archive has kept, by the runs of `record`, or alone where there
 *  are none, and writes the mended one beside it, X.repaired.simplemap as X was compressed. What
 *  became of it, in one line. @throws DataError where the run cannot be read or written. */
std::string keepRepaired(const std::string& kept, const std::vector<std::string>& record,
                         const ArchiveArguments& arguments) {
  if (record.empty()) {
    const Run run = readRun(kept, toCompareOptions(arguments.options));
    if (run.scans.empty()) return printable(kept) + ": has no scans: nothing can be mended\n";
    return writeRepaired(run, repairAlone(run, checkRun(run)));
  }
  SiteArguments site = arguments;
  site.files = record;
  site.files.push_back(kept);
  const auto runs = solvedRunsOf(site);
  for (const RepairedRun& one : repairRuns(runs->solved, rejoinPieces(runs->solved)))
    if (const Run& run = runs->read.runs[one.run]; run.file == kept) return writeRepaired(run, one);
  return printable(kept) + ": has no scans, or fits no other run: nothing can be mended\n";
}

void addOne(Archive& archive, const std::string& file, const AddRunOptions& options,
            const ArchiveArguments& arguments) {
  std::vector<std::string> record;  // as it is before this run belongs to it
  if (arguments.repairs)
    for (const HistoryRun& run :
         recordRuns(archive.runs(options.site), options.most, [](const HistoryRun&) {}))
      record.push_back(run.file);
  const AddedRun added = addRun(archive, file, options);
  if (!arguments.running.isQuiet) print(lineOf(file, added));
  if (!added.roomsFailed.empty()) printError(added.roomsFailed);
  if (!arguments.repairs || added.wasKnown || !added.isPlaced) return;
  const std::string kept = keepMap(file, mapSha256(file), options.kept);  // is there already
  const std::string line = keepRepaired(kept, record, arguments);
  if (!arguments.running.isQuiet) print(line);
}

/** A mistake leaves no archive behind. */
void checkThatOneCanBeRead(const ArchiveArguments& arguments, const AddRunOptions& options) {
  std::error_code ignored;
  if (std::filesystem::exists(arguments.archive, ignored) || ignored) return;
  std::vector<std::string> problems;
  for (const std::string& file : arguments.files) {
    try {
      (void)loadGrid(file, options.compare.extract.loadGrid);
      return;
    } catch (const DataError& error) {
      problems.emplace_back(error.what());
    }
  }
  for (std::size_t i = 0; i + 1 < problems.size(); ++i) printError(problems[i]);
  throw DataError(problems.back());
}

}  // namespace

AddRunOptions addOptionsOf(const ArchiveArguments& arguments) {
  if (arguments.robot.empty())
    throw UsageError("--robot: is empty: name the robot, or leave the option out");
  for (const std::string* name : {&arguments.robot, &arguments.site})
    if (name->size() > kLongestName)
      throw UsageError("--robot and --site: a name has at most 200 bytes: give a shorter one");
  AddRunOptions options;
  options.robot = arguments.robot, options.most = arguments.most;
  options.kept = arguments.kept;
  if (arguments.repairs && arguments.kept.empty())
    throw UsageError("--repair: a mended run lies beside its copy: name a folder with --keep");
  if (!arguments.time.empty()) {
    options.time = parseTime(arguments.time);
    if (!options.time)
      throw UsageError("--time: " + arguments.time + " is not a time: give 2026-11-22T03:00");
    if (isToCome(*options.time))
      throw UsageError("--time: " + arguments.time + " is still to come: give the time of the run");
  }
  options.compare = toCompareOptions(arguments.options);
  options.compare.compare.forEach =
      onThreads(arguments.running.threads, !arguments.running.isQuiet);
  options.compare.onUnread = [](const LeftOutRun& run) {
    printError(run.file + ": is not compared with: " + run.reason);
  };
  return options;
}

std::string siteToAddTo(const ArchiveArguments& arguments, const Archive& archive) {
  if (!arguments.site.empty()) return arguments.site;
  const std::vector<std::string> sites = archive.sites();
  if (sites.size() == 1) return sites.front();
  if (sites.size() > 1)
    throw UsageError(arguments.archive + ": has several sites: name one with --site");
  const std::string stem = std::filesystem::path(arguments.archive).stem().string();
  return stem.empty() ? "site" : stem;
}

int addToArchive(const ArchiveArguments& arguments) {
  AddRunOptions options = addOptionsOf(arguments);
  checkThatOneCanBeRead(arguments, options);
  Archive archive(arguments.archive, Archive::Access::orNew);
  options.site = siteToAddTo(arguments, archive);
  PairFolder cache(arguments.cache);
  options.compare.compare.kept = cache.kept();
  std::set<std::string> missing;
  options.onMissing = [&](const HistoryRun& run) { missing.insert(run.file); };
  const int exitCode = doEach(
      arguments.files, [&](const std::string& file) { addOne(archive, file, options, arguments); });
  if (!missing.empty()) printError(missingText(missing));
  if (!cache.failure().empty()) printError(cache.failure());
  return exitCode;
}

}  // namespace roomgraph
