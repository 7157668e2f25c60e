#pragma once
#include <string>
#include <vector>

#include "Database.h"
#include "roomgraph/archive/SiteHistory.h"

namespace roomgraph {

/** The runs of a site without rooms, and of their figures only those of these names. */
std::vector<HistoryRun> readRuns(Database& database, const std::string& site,
                                 const std::vector<std::string>& figures);

/** All that the tables have of a site; empty for one that is not there. */
SiteHistory readHistory(Database& database, const std::string& site);

/** The rooms that are known of a site. */
SiteFile readLedger(Database& database, const std::string& site);

}  // namespace roomgraph
