#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/Notes.h"
#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

// In:   the names of map files
// Out:  Comparison
// Next: comparisonJson, comparisonReport

struct CompareMapsOptions {
  ExtractOptions extract;       ///< of each map
  CompareRunsOptions compare;   ///< its reference is that of the file below
  std::string reference;        ///< map file to measure all runs against; empty for none
  bool estimatesScale = false;  ///< of bare pictures
  /** Told of each file that cannot be read, in the order of the files, on the calling thread. */
  std::function<void(const LeftOutRun&)> onUnread = [](const LeftOutRun&) {};
  /** Told in the same way what is odd about a file that was read. */
  std::function<void(const std::string& file, const Note&)> onNote = [](const std::string&,
                                                                        const Note&) {};
};

/** What a user may set by name; points into `options`. */
[[nodiscard]] FieldTable describe(CompareMapsOptions& options);

/** The same as Comparison::options tells it. */
[[nodiscard]] std::vector<UsedOption> usedOptions(CompareMapsOptions options);

/** Sets what a comparison was made with. What the table does not know is left out.
 *  @throws UsageError for a value out of range. */
void setUsed(const Comparison& comparison, FieldTable& table);

/** Map files that were read. */
struct ReadRuns {
  std::vector<Run> runs;                 ///< in the order of sortRuns
  std::optional<std::size_t> reference;  ///< of `runs`
  std::vector<LeftOutRun> leftOut;       ///< files that could not be used, by name
};

/** Reads all maps, the reference behind the others, each with its scans. A file that cannot be
 *  read, or has no walls, is left out. With estimatesScale, each bare picture is read at the scale
 *  at which it fits the maps that have one (the reference alone, if it has one); where there is
 *  none, it is left out as of another site. The same for any order of the files.
 *  @throws DataError where no map at all, or the reference, cannot be used, or no map tells a
 *  scale.
 *  @throws UsageError where scales are to be estimated, and no map is a bare picture or all are
 *  aligned already. */
[[nodiscard]] ReadRuns readRuns(const std::vector<std::string>& files,
                                const CompareMapsOptions& options);

/** One run, as readRuns reads it. @throws DataError where it cannot be used. */
[[nodiscard]] Run readRun(const std::string& file, CompareMapsOptions options);

/** Compares what was read, see compareRuns; what was left out there is left out here, too. */
[[nodiscard]] Comparison compareMaps(const ReadRuns& read, const CompareMapsOptions& options);

/** The maps of a comparison that was read back: those of `files` that are maps of its runs, told by
 *  their content, with the names of the runs, their walls, and up to `wallsPerScan` of each of
 *  their scans. Other files are left out. They are read with the options of the comparison.
 *  @throws DataError where a file cannot be read. */
[[nodiscard]] std::vector<Run> readMapsOf(const Comparison& comparison,
                                          const std::vector<std::string>& files,
                                          int wallsPerScan = kWallsPerScan);

/** Files that may be the map of a run: where the comparison says that it lay, and those of its name
 *  beside the file of the comparison, one folder above, and in the current folder. */
[[nodiscard]] std::vector<std::string> mapsNear(const ComparedRun& run,
                                                const std::string& comparisonFile);

/** Both in one:
 *
 *      const Comparison comparison = compareMaps({"a.simplemap", "b.simplemap", "c.yaml"}, {});
 *      const std::string best = comparison.runs.front().name;
 */
[[nodiscard]] Comparison compareMaps(const std::vector<std::string>& files,
                                     const CompareMapsOptions& options);

}  // namespace roomgraph
