#include "roomgraph/archive/add_run.h"

#include <filesystem>

#include "roomgraph/archive/record_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/map_files/map_sha256.h"
#include "roomgraph/report/run_check_json.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

/** All that is to be compared. @throws DataError where the new map cannot be read. */
ReadRuns readAll(std::vector<std::string> files, const std::string& added,
                 const AddRunOptions& options) {
  files.push_back(added);
  CompareMapsOptions compare = options.compare;
  std::string failure;
  compare.onUnread = [&](const LeftOutRun& run) {
    if (run.file == added) failure = run.reason;
    if (run.file != added) options.compare.onUnread(run);
  };
  try {
    ReadRuns read = readRuns(files, compare);
    if (failure.empty()) return read;
  } catch (const DataError&) {
    if (failure.empty()) throw;
  }
  throw DataError(added + ": " + failure);
}

/** What the added run tells of itself, where the others do not judge it. */
void checkAlone(const ReadRuns& read, const std::string& sha256, Comparison& comparison) {
  const auto isAdded = [&](const auto& run) { return run.sha256 == sha256; };
  const Run* run = findIf(read.runs, isAdded);
  ComparedRun* compared = findIf(comparison.runs, isAdded);
  if (!run || !compared) return;
  if (run->scans.empty() || (compared->score && compared->score->isMeaningful)) return;
  const RunCheck check = checkRun(*run);
  compared->reason += "; by itself: " + toldText(check);
  const double scans = double(run->scans.size());
  Measure error{kSelfError, check.selfError, "m", scans, {}, {}, check.selfError.has_value()};
  if (check.selfError) error.low = check.low, error.high = check.high;
  compared->measures.push_back(error);
  compared->measures.push_back(
      {kSelfBreaks, double(check.breaks.size()), "1", scans, {}, {}, true});
}

/** The new run beside those of its site that are worth it. */
Addition comparedWithRecord(const Archive& archive, const std::string& added,
                            const std::string& sha256, const AddRunOptions& options) {
  const std::vector<HistoryRun> known = archive.runs(options.site);
  const auto record = recordRuns(known, options.most, options.onMissing);
  const ReadRuns read = readAll(mapped(record, &HistoryRun::file), added, options);
  Addition addition;
  addition.site = options.site, addition.knownRuns = known.size();
  addition.runs = {{sha256, options.robot, added, options.time ? *options.time : runTime(added)}};
  addition.comparison = compareMaps(read, options.compare);
  checkAlone(read, sha256, addition.comparison);
  return addition;
}

AddedRun resultOf(const Addition& addition, const std::string& file, const Added& added) {
  AddedRun result;
  result.sha256 = addition.runs.front().sha256;
  result.wasKnown = added.runs == 0;  // another program was faster
  result.roomsFailed = added.roomsFailed;
  const Comparison& comparison = addition.comparison;
  for (const ComparedRun& run : comparison.runs)
    if (run.sha256 == addition.runs.front().sha256)
      result.isPlaced = true, result.score = run.score, result.reason = run.reason;
  for (const LeftOutRun& run : comparison.leftOut)
    if (run.file == file) result.reason = run.reason;
  return result;
}

}  // namespace

AddedRun addRun(Archive& archive, const std::string& file, const AddRunOptions& options) {
  const std::string added = fs::absolute(file).lexically_normal().string();
  const std::string sha256 = mapSha256(added);
  Added result;
  Addition addition;
  do {  // anew where another program was faster
    if (archive.knows(options.site, sha256)) return {sha256, true, false, {}, "", ""};
    addition = comparedWithRecord(archive, added, sha256, options);
    if (!options.kept.empty()) addition.runs.front().file = keepMap(added, sha256, options.kept);
    result = archive.record(addition);
  } while (result.isOutdated);
  if (result.runs == 0 && !archive.knows(options.site, sha256))
    throw DataError(added + ": was changed while it was added: add it again");
  AddedRun told = resultOf(addition, added, result);
  for (const HistoryRun& run : archive.runs(options.site))
    if (run.sha256 == sha256 && !run.isPlaced)  // the site is that of other runs
      told.isPlaced = false, told.score.reset(), told.reason = run.reason;
  return told;
}

}  // namespace roomgraph
