#include "edit_runs.h"

#include <vector>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"

namespace roomgraph {
namespace {

constexpr std::size_t kLeastDigits = 8;  // of a SHA-256 that names a run

bool isMeant(const std::string& run, const std::string& file, const std::string& sha256) {
  return run == file || run == fileName(file) ||
         (run.size() >= kLeastDigits && sha256.compare(0, run.size(), run) == 0);
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

void removeRun(Database& database, const std::string& site, const std::string& run) {
  Transaction transaction(database);
  const std::int64_t key = keyOfRun(database, site, run);
  for (const char* table : {"figure", "sighting", "compared"})
    Statement(database, std::string("DELETE FROM ") + table + " WHERE run = ?").with(key).run();
  Statement(database, "DELETE FROM run WHERE id = ?").with(key).run();
  transaction.commit();
}

void renameRobot(Database& database, const std::string& site, const std::string& robot,
                 const std::string& name) {
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

}  // namespace roomgraph
