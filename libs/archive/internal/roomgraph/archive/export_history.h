#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/add_run.h"
#include "roomgraph/archive/watch_site.h"

namespace roomgraph {

// In:   SiteHistory, SiteWatch
// Out:  text of files
// Next: a file

/** A site, and what its history tells. */
struct WatchedSite {
  SiteHistory history;
  SiteWatch watch;
};

/** One line per run, below a line of column names: by site, then by time. Empty fields for what
 *  cannot be told; the map error is there whether it can be trusted or not. */
std::string historyCsv(const std::vector<WatchedSite>& sites);

/** All of the history, and what it tells, as JSON of format "roomgraph/archive", version 1; see the
 *  schema in share/roomgraph/schema. */
std::string historyJson(const std::vector<WatchedSite>& sites);

/** The state of each robot in each site as Prometheus' node_exporter collects it from text files:
 *  whether its latest map may be rolled out, the figures of that map, where they can be trusted,
 *  and the alarms, 0 or 1. */
std::string historyPrometheus(const std::vector<WatchedSite>& sites);

/** A few lines for people: each robot, then the rooms that have changed. */
std::string historyText(const WatchedSite& site);

/** One line of JSON of format "roomgraph/watch", version 1; see the schema in
 *  share/roomgraph/schema. `robot` is none where no run of it can be judged. */
std::string addedRunJson(const std::string& file, const AddedRun& run, const RobotWatch* robot);

/** The same of a file that could not be added, and why. */
std::string failedRunJson(const std::string& file, const std::string& error);

}  // namespace roomgraph
