#include <algorithm>
#include <vector>

#include "Database.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/report/site_json.h"

namespace roomgraph {
namespace {

bool isMeant(const std::string& run, const std::string& file, const std::string& sha256) {
  return run == file || run == fileName(file) ||
         (run.size() >= 8 && sha256.compare(0, run.size(), run) == 0);
}

std::int64_t keyOfRun(Database& database, const std::string& site, const std::string& run) {
  Statement rows(database,
                 "SELECT run.id, file, sha256 FROM run JOIN site ON run.site = site.id WHERE "
                 "site.name = ?");
  rows.with(site);
  std::vector<std::int64_t> keys;
  while (rows.step())
    if (isMeant(run, rows.text(1), rows.text(2))) keys.push_back(rows.integer(0));
  if (keys.empty())
    throw DataError(database.file() + ": has no run " + run + " in " + site +
                    ": 'list' names those that it has");
  if (keys.size() > 1)
    throw DataError(database.file() + ": has several runs named " + run +
                    ": name one by its whole file or its SHA-256, which 'export' tells");
  return keys.front();
}

}  // namespace

void Archive::removeRun(const std::string& site, const std::string& run) {
  Database& database = *database_;
  Transaction transaction(database);
  const std::int64_t key = keyOfRun(database, site, run);
  for (const char* table : {"figure", "sighting", "compared"})
    Statement(database, std::string("DELETE FROM ") + table + " WHERE run = ?").with(key).run();
  Statement(database, "DELETE FROM run WHERE id = ?").with(key).run();
  transaction.commit();
}

void Archive::renameRobot(const std::string& site, const std::string& robot,
                          const std::string& name) {
  Database& database = *database_;
  Transaction transaction(database);
  Statement(database,
            "UPDATE run SET robot = ? WHERE robot = ? AND site = (SELECT id FROM site WHERE name = "
            "?)")
      .with(name, robot, site)
      .run();
  if (database.number("SELECT changes()") == 0)
    throw DataError(database.file() + ": has no robot " + robot + " in " + site +
                    ": 'list' names those that it has");
  transaction.commit();
}

void Archive::nameRoom(const std::string& site, const std::string& id, const std::string& name) {
  Database& database = *database_;
  Transaction transaction(database);
  Statement row(database, "SELECT ledger FROM site WHERE name = ?");
  const std::string text = row.with(site).step() ? row.text(0) : "";
  SiteFile ledger = text.empty() ? SiteFile() : parseSiteJson(text, database.file());
  const auto room = std::find_if(ledger.rooms.begin(), ledger.rooms.end(),
                                 [&](const KnownRoom& known) { return known.id == id; });
  if (room == ledger.rooms.end())
    throw DataError(database.file() + ": has no room " + id + ": 'rooms' lists those that it has");
  room->name = name;
  Statement(database, "UPDATE site SET ledger = ? WHERE name = ?")
      .with(siteJson(ledger), site)
      .run();
  transaction.commit();
}

}  // namespace roomgraph
