
#include "Database.h"
#include "read_history.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/archive/SiteHistory.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/report/site_json.h"

namespace roomgraph {

void Archive::removeRun(const std::string& site, const std::string& run) {
  Database& database = *database_;
  const std::string sha256 = namedRun(runs(site), run, database.file()).sha256;
  Transaction transaction(database);
  const std::string key =
      "(SELECT run.id FROM run JOIN site ON run.site = site.id WHERE site.name = ? AND sha256 = ?)";
  for (const char* rows :
       {"figure WHERE run", "sighting WHERE run", "compared WHERE run", "run WHERE id"})
    database.run(std::string("DELETE FROM ") + rows + " = " + key, site, sha256);
  transaction.commit();
}

void Archive::renameRobot(const std::string& site, const std::string& robot,
                          const std::string& name) {
  Database& database = *database_;
  Transaction transaction(database);
  database.run(
      "UPDATE run SET robot = ? WHERE robot = ? AND site = (SELECT id FROM site WHERE name = ?)",
      name, robot, site);
  if (database.number("SELECT changes()") == 0)
    throw DataError(database.file() + ": has no robot " + robot + " in " + site +
                    ": 'list' names those that it has");
  transaction.commit();
}

void Archive::nameRoom(const std::string& site, const std::string& id, const std::string& name) {
  Database& database = *database_;
  Transaction transaction(database);
  SiteFile ledger = readLedger(database, site);
  SiteRoom* room = findIf(ledger.rooms, [&](const SiteRoom& known) { return known.id == id; });
  if (!room)
    throw DataError(database.file() + ": has no room " + id + ": 'rooms' lists those that it has");
  room->name = name;
  database.run("UPDATE site SET ledger = ? WHERE name = ?", siteJson(ledger), site);
  transaction.commit();
}

}  // namespace roomgraph
