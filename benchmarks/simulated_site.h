#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

/** All runs of a site, related once; any subset of them can then be compared. */
struct SimulatedSite {
  std::string name;
  std::vector<Run> runs;
  std::vector<double> truth;                    ///< map_rms_m of each run
  std::vector<Transform2D> toTruth;             ///< true frame <- run, for each run
  std::vector<std::optional<MapBreak>> breaks;  ///< that each run was given, in the true frame
  std::vector<std::string> settings;            ///< of each run; runs with the same differ in seed
  MapPairs related;                             ///< of all runs
};

/** The folders in `data` that have a truth.csv and `only` in their name, by name.
 *  @throws DataError where there is none. */
std::vector<std::string> simulatedSites(const std::string& data, const std::string& only);

/** Reads the runs of a folder, with their scans if the extension is that of simplemaps. */
SimulatedSite readSite(const std::string& folder, const std::string& extension);

}  // namespace roomgraph
