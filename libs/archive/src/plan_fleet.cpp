#include "roomgraph/archive/plan_fleet.h"

#include <cmath>
#include <map>
#include <set>

#include "roomgraph/archive/record_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/version.h"
#include "roomgraph/map_files/map_sha256.h"

namespace roomgraph {
namespace {

/** The new runs of a site, by content. */
using NewRuns = std::map<std::string, HistoryRun>;

std::map<std::string, NewRuns> newRunsOf(const RunList& listed, const Archive& archive,
                                         const PlanFleetOptions& options) {
  std::map<std::string, NewRuns> sites;
  for (auto [site, run] : listed) {
    try {
      run.sha256 = mapSha256(run.file);
      if (archive.knows(site, run.sha256)) continue;
      if (std::isnan(run.time)) run.time = runTime(run.file);
      sites[site].insert({run.sha256, run});
    } catch (const DataError& error) {
      options.onUnread(printable(site) + ": " + error.what());
    }
  }
  return sites;
}

}  // namespace

std::vector<FleetTask> planFleet(const RunList& listed, const Archive& archive,
                                 const PlanFleetOptions& options) {
  std::vector<FleetTask> tasks;
  for (const auto& [site, news] : newRunsOf(listed, archive, options)) {
    FleetTask task;
    task.site = site, task.newRuns = news.size();
    for (const auto& [sha256, run] : news) task.runs.push_back(run);
    for (const HistoryRun& run : recordRuns(archive.runs(site), options.most, options.onMissing))
      task.runs.push_back(run);
    task.key = keyOf(task, options.compare);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

std::string keyOf(const FleetTask& task, const CompareMapsOptions& options) {
  std::set<std::string> runs;
  for (const HistoryRun& run : task.runs) runs.insert(run.sha256 + " " + run.file + "\n");
  std::string text = std::string(version()) + "\n" + task.site + "\n";
  for (const std::string& run : runs) text += run;
  for (const UsedOption& used : usedOptions(options))
    text += used.section + "." + used.name + "=" + used.value + "\n";
  return sha256Of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace roomgraph
