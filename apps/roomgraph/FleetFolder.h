#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/fleet/FleetTask.h"

namespace roomgraph {

/** Where a plan and its results lie: tasks.jsonl, options.ini, and results/KEY for each task with
 *  comparison.json, or where a map could not be used partial.json and failures.txt. */
class FleetFolder {
 public:
  explicit FleetFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /** Takes the place of an earlier plan. */
  void write(const std::vector<FleetTask>& tasks, const CompareMapsOptions& options) const;
  /** @throws DataError where there is no plan, or it is damaged. */
  std::vector<FleetTask> tasks() const;
  CompareMapsOptions options() const;

  std::filesystem::path taskFile() const { return folder_ / "tasks.jsonl"; }
  std::filesystem::path resultOf(const FleetTask& task) const {
    return of(task, "comparison.json");
  }
  std::filesystem::path partOf(const FleetTask& task) const { return of(task, "partial.json"); }
  std::filesystem::path failuresOf(const FleetTask& task) const { return of(task, "failures.txt"); }

 private:
  std::filesystem::path optionsFile() const { return folder_ / "options.ini"; }
  std::filesystem::path of(const FleetTask& task, const char* name) const {
    return folder_ / "results" / task.key / name;
  }

  std::filesystem::path folder_;
};

}  // namespace roomgraph
