#include "schema.h"

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

constexpr std::int64_t kArchive = 0x726d6772;  // "rmgr", as `file` shows it
constexpr std::int64_t kVersion = 1;
constexpr const char* kTables = R"(
-- The runs of one building, and its rooms as a text of format roomgraph/site.
CREATE TABLE site (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  ledger TEXT NOT NULL DEFAULT ''
) STRICT;

-- All that figures depend on besides the maps.
CREATE TABLE settings (
  id INTEGER PRIMARY KEY,
  version TEXT NOT NULL,
  options TEXT NOT NULL,
  UNIQUE (version, options)
) STRICT;

CREATE TABLE comparison (
  id INTEGER PRIMARY KEY,
  site INTEGER NOT NULL REFERENCES site,
  settings INTEGER NOT NULL REFERENCES settings,
  verdict TEXT NOT NULL
) STRICT;

-- A map, once for all: its content tells it. state: 'placed' in the site, or of an 'other site'.
CREATE TABLE run (
  id INTEGER PRIMARY KEY,
  site INTEGER NOT NULL REFERENCES site,
  sha256 TEXT NOT NULL,
  robot TEXT NOT NULL,
  time REAL NOT NULL,
  file TEXT NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('placed', 'other site')),
  reason TEXT NOT NULL,
  comparison INTEGER NOT NULL REFERENCES comparison,
  UNIQUE (site, sha256)
) STRICT;
CREATE INDEX run_by_time ON run (site, time);

-- Which runs were compared with each other.
CREATE TABLE compared (
  comparison INTEGER NOT NULL REFERENCES comparison,
  run INTEGER NOT NULL REFERENCES run,
  PRIMARY KEY (comparison, run)
) STRICT, WITHOUT ROWID;

-- Those of run.comparison.
CREATE TABLE figure (
  run INTEGER NOT NULL REFERENCES run,
  name TEXT NOT NULL,
  value REAL, low REAL, high REAL,
  unit TEXT NOT NULL,
  support REAL NOT NULL,
  meaningful INTEGER NOT NULL,
  PRIMARY KEY (run, name)
) STRICT, WITHOUT ROWID;

-- What a run has of a room of the site, see roomgraph/comparison.
CREATE TABLE sighting (
  run INTEGER NOT NULL REFERENCES run,
  room TEXT NOT NULL,
  sighting TEXT NOT NULL CHECK (sighting IN ('seen', 'gone', 'unvisited')),
  pieces INTEGER NOT NULL,
  merged INTEGER NOT NULL,
  doors INTEGER NOT NULL,
  area REAL, shift REAL, agreement REAL,
  PRIMARY KEY (run, room)
) STRICT, WITHOUT ROWID;

CREATE VIEW room AS
  SELECT site.name AS site, value ->> 'id' AS id, value ->> 'name' AS name,
    value ->> 'kind' AS kind, value ->> 'x' AS x, value ->> 'y' AS y,
    value ->> 'area_m2' AS area
  FROM site, json_each(site.ledger, '$.rooms') WHERE site.ledger <> '';
)";

/** Whether it is an archive; false for an empty file. */
bool isArchive(Database& database) {
  // Asked first: between the two questions another program may make it an archive.
  const bool isEmpty = database.number("SELECT count(*) FROM sqlite_schema") == 0;
  if (database.number("PRAGMA application_id") == kArchive) return true;
  if (!isEmpty) refuse(database.file(), "is a database of another program", "name an archive");
  return false;
}

}  // namespace

void migrate(Database& database) {
  const auto version = [&] { return database.number("PRAGMA user_version"); };
  if (!isArchive(database) || version() < kVersion) {
    Transaction transaction(database);
    // Another program may have been faster.
    if (!isArchive(database)) database.run("PRAGMA application_id = " + std::to_string(kArchive));
    if (version() < kVersion)
      database.run(std::string(kTables) + "; PRAGMA user_version = " + std::to_string(kVersion));
    transaction.commit();
  }
  if (version() > kVersion)
    refuse(database.file(), "was written by a later version of roomgraph", "use that version");
}

}  // namespace roomgraph
