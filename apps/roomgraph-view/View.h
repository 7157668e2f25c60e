#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/mrpt_plugin/CRoomGraph.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/report/faults.h"

namespace roomgraph {

/** What there is to look at: one map with its graph, or runs of a site. */
struct View {
  Comparison comparison;      ///< of one map: its run alone, and that without a score
  std::vector<Fault> faults;  ///< breaks; of one map, all that it tells of itself
  std::vector<Run> runs;      ///< in the order of the comparison's; those without a map are missing
  /** Of one map, with which it is extracted anew when an option changes. */
  std::optional<GreyMap> map;
  ExtractOptions options;
  std::optional<Stages> stages;     ///< of that map
  std::optional<CRoomGraph> graph;  ///< their result
  double seconds = 0;               ///< that the extraction took
  double turn = 0;                  ///< of the site, about its origin, to stand upright [rad]

  /** Screen, with x to the right, <- frame of the site [m]. */
  Transform2D onScreen() const { return {0, 0, turn}; }
  const Run* runNamed(const std::string& name) const { return findRun(runs, name); }
  /** Of the run at this place of the comparison; empty without scans. */
  const std::vector<PathPose>& path(std::size_t run) const { return comparison.runs[run].path; }
};

/** Reads what was named: one map, which is checked by itself, several runs, which are compared, or
 *  a comparison.json with its maps behind it. Those that are not named are looked for beside it,
 *  one folder above and in the current one. `say` is told what could not be used.
 *  @throws DataError and UsageError where nothing is left to look at. */
View loadView(const std::vector<std::string>& files, const ExtractOptions& options,
              const std::function<void(const std::string&)>& say);

/** Extracts the one map anew, with the options of the view; of them only those of the steps behind
 *  the Voronoi diagram may have changed. */
void extractAgain(View& view);

}  // namespace roomgraph
