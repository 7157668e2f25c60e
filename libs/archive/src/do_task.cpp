#include "roomgraph/archive/do_task.h"

#include <algorithm>
#include <map>

#include "roomgraph/archive/plan_fleet.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** Takes out what is not as it was planned. */
void dropOthers(ReadRuns& read, const FleetTask& task, std::vector<std::string>& failures) {
  const std::string reason = "is another map now than when it was planned";
  std::map<std::string, std::string> planned;
  for (const HistoryRun& run : task.runs) planned[run.file] = run.sha256;
  const auto isOther = [&](const Run& run) { return planned[run.file] != run.sha256; };
  for (const Run& run : read.runs) {
    if (!isOther(run)) continue;
    read.leftOut.push_back({run.name, run.file, reason, false});
    failures.push_back(run.file + ": " + reason);
  }
  read.runs.erase(std::remove_if(read.runs.begin(), read.runs.end(), isOther), read.runs.end());
}

}  // namespace

TaskResult doTask(const FleetTask& task, const CompareMapsOptions& options) {
  if (keyOf(task, options) != task.key)
    throw DataError("task of " + task.site +
                    ": was planned by another version or with other options: plan again");
  TaskResult result;
  CompareMapsOptions compare = options;
  compare.onUnread = [&](const LeftOutRun& run) {
    result.failures.push_back(run.file + ": " + run.reason);
  };
  std::vector<std::string> files;
  for (const HistoryRun& run : task.runs) files.push_back(run.file);
  ReadRuns read = readRuns(files, compare);
  dropOthers(read, task, result.failures);
  if (read.runs.empty()) throw DataError("task of " + task.site + ": no map could be used");
  result.comparison = compareMaps(read, compare);
  return result;
}

}  // namespace roomgraph
