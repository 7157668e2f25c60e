#include "roomgraph/archive/add_run.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "roomgraph/archive/choose_record.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "roomgraph/scans/load_run_info.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

double timeOf(const std::string& file) {
  if (const auto info = loadRunInfo(file); info && info->start) return *info->start;
  // C++17 has no clock in common with that of files, so the distance to now is taken.
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file);
  const auto written = std::chrono::system_clock::now() -
                       std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
  return double(
      std::chrono::duration_cast<std::chrono::seconds>(written.time_since_epoch()).count());
}

bool isThere(const KnownRun& run) {
  try {
    return mapSha256(run.file) == run.sha256;
  } catch (const DataError&) {
    return false;
  }
}

/** The files of the runs to compare with. */
std::vector<std::string> recordOf(const Archive& archive, const AddRunOptions& options) {
  const std::vector<KnownRun> runs = archive.runs(options.site);
  const auto isUsable = [&](const KnownRun& run) {
    const bool isUsed = isThere(run);
    if (!isUsed) options.onMissing(run);
    return isUsed;
  };
  std::vector<std::string> files;
  for (const std::size_t i : chooseRecord(runs, options.most, isUsable))
    files.push_back(runs[i].file);
  return files;
}

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

AddedRun resultOf(const Addition& addition, const Added& added) {
  AddedRun result;
  result.wasKnown = added.runs == 0;  // another program was faster
  result.roomsFailed = added.roomsFailed;
  const Comparison& comparison = addition.comparison;
  for (const ComparedRun& run : comparison.runs)
    if (run.sha256 == addition.runs.front().sha256)
      result.isPlaced = true, result.score = run.score, result.reason = run.reason;
  for (const LeftOutRun& run : comparison.leftOut)
    if (run.file == addition.runs.front().file) result.reason = run.reason;
  return result;
}

}  // namespace

AddedRun addRun(Archive& archive, const std::string& file, const AddRunOptions& options) {
  const std::string added = fs::absolute(file).lexically_normal().string();
  const std::string sha256 = mapSha256(added);
  if (archive.knows(options.site, sha256)) return {true, false, {}, "", ""};
  Addition addition;
  addition.site = options.site;
  addition.runs = {{sha256, options.robot, added, options.time.value_or(0)}};
  const ReadRuns read = readAll(recordOf(archive, options), added, options);
  if (!options.time) addition.runs.front().time = timeOf(added);
  addition.comparison = compareMaps(read, options.compare);
  return resultOf(addition, archive.record(addition));
}

}  // namespace roomgraph
