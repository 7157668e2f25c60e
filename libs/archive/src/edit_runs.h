#pragma once
#include <string>

#include "Database.h"

namespace roomgraph {

// Ours
// In:   an archive, and one of its runs or robots
// Out:  the archive without that run, or with another name for that robot
// Next: watchSite

/** Takes a run out of a site, with its figures and sightings. The figures of other runs stay as
 *  they were told while it was there. `run` is its file as it is listed, the name of that file, or
 *  at least eight digits of its SHA-256.
 *  @throws DataError where there is no such run, or where several could be meant. */
void removeRun(Database& database, const std::string& site, const std::string& run);

/** Gives all runs of a robot in a site another robot's name, which may be there already.
 *  @throws DataError where the site has no such robot. */
void renameRobot(Database& database, const std::string& site, const std::string& robot,
                 const std::string& name);

}  // namespace roomgraph
