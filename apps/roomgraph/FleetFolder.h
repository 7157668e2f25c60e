#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "roomgraph/archive/FleetTask.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

/** As they stand in a file of failures: each on a line of its own. */
std::string linesOf(const std::vector<std::string>& failures);

/** Where a plan and its results lie: tasks.jsonl, options.ini, failures.txt with a line for each
 *  map that could not be planned, and results/KEY for each task with comparison.json or, where a
 *  map could not be used, partial.json and failures.txt. */
class FleetFolder {
 public:
  explicit FleetFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /** Takes the place of an earlier plan. `failures` has a line for each map that is in no task. */
  void write(const std::vector<FleetTask>& tasks, const CompareMapsOptions& options,
             const std::vector<std::string>& failures) const;
  /** @throws DataError where there is no plan, or it is damaged. */
  std::vector<FleetTask> tasks() const;
  CompareMapsOptions options() const;
  /** The lines of a file of failures, of the plan's own or of that of a task. None where there is
   *  no such file. @throws DataError where it cannot be read. */
  static std::vector<std::string> failuresIn(const std::filesystem::path& file);

  std::filesystem::path optionsFile() const { return folder_ / "options.ini"; }
  std::filesystem::path taskFile() const { return folder_ / "tasks.jsonl"; }
  std::filesystem::path resultOf(const FleetTask& task) const {
    return of(task, "comparison.json");
  }
  std::filesystem::path partOf(const FleetTask& task) const { return of(task, "partial.json"); }
  std::filesystem::path failures() const { return folder_ / "failures.txt"; }
  std::filesystem::path failuresOf(const FleetTask& task) const { return of(task, "failures.txt"); }

 private:
  std::filesystem::path of(const FleetTask& task, const char* name) const {
    return folder_ / "results" / task.key / name;
  }

  std::filesystem::path folder_;
};

}  // namespace roomgraph
