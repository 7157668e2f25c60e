#include "read_history.h"

#include <map>

#include "roomgraph/base/Error.h"
#include "roomgraph/report/site_json.h"

namespace roomgraph {
namespace {

/** Of the runs of a site, each behind its key in the tables. */
using RunPlaces = std::map<std::int64_t, std::size_t>;

/** @throws DataError where the tables name a run that they do not have. */
HistoryRun& runOf(std::int64_t key, const Database& database, const RunPlaces& places,
                  std::vector<HistoryRun>& runs) {
  const auto place = places.find(key);
  if (place == places.end())
    throw DataError(database.file() +
                    ": is damaged, its tables contradict each other: " + "bring back a copy of it");
  return runs[place->second];
}

RunPlaces readRuns(Database& database, const std::string& site, std::vector<HistoryRun>& runs) {
  Statement rows(database,
                 "SELECT run.id, sha256, robot, file, time, state = 'placed', reason, version "
                 "FROM run JOIN site ON run.site = site.id "
                 "JOIN comparison ON run.comparison = comparison.id "
                 "JOIN settings ON comparison.settings = settings.id "
                 "WHERE site.name = ? ORDER BY time, run.id");
  rows.with(site);
  RunPlaces places;
  while (rows.step()) {
    places[rows.integer(0)] = runs.size();
    HistoryRun run;
    run.sha256 = rows.text(1), run.robot = rows.text(2), run.file = rows.text(3);
    run.time = rows.number(4), run.isPlaced = rows.integer(5) != 0;
    run.reason = rows.text(6), run.version = rows.text(7);
    runs.push_back(std::move(run));
  }
  return places;
}

/** `name` is that of the figures, "%" for all. */
void readFigures(Database& database, const std::string& site, const std::string& name,
                 const RunPlaces& places, std::vector<HistoryRun>& runs) {
  Statement rows(database,
                 "SELECT run, figure.name, value, low, high, unit, support, meaningful "
                 "FROM figure JOIN run ON figure.run = run.id JOIN site ON run.site = site.id "
                 "WHERE site.name = ? AND figure.name LIKE ? ORDER BY run, figure.name");
  rows.with(site, name);
  while (rows.step()) {
    Measure figure;
    figure.name = rows.text(1), figure.value = rows.numberIfAny(2);
    figure.low = rows.numberIfAny(3), figure.high = rows.numberIfAny(4);
    figure.unit = rows.text(5), figure.support = rows.number(6);
    figure.isMeaningful = rows.integer(7) != 0;
    runOf(rows.integer(0), database, places, runs).figures.push_back(std::move(figure));
  }
}

void readSightings(Database& database, const std::string& site, const RunPlaces& places,
                   std::vector<HistoryRun>& runs) {
  Statement rows(database,
                 "SELECT run, room, sighting, pieces, merged, doors, area, shift, agreement "
                 "FROM sighting JOIN run ON sighting.run = run.id JOIN site ON run.site = site.id "
                 "WHERE site.name = ? ORDER BY run, room");
  rows.with(site);
  while (rows.step()) {
    RoomSeen seen;
    seen.room = rows.text(1);
    seen.sighting = valueOfName<RoomSighting>(rows.text(2)).value_or(RoomSighting::unvisited);
    seen.pieces = int(rows.integer(3)), seen.isMerged = rows.integer(4) != 0;
    seen.doors = int(rows.integer(5)), seen.area = rows.numberIfAny(6);
    seen.shift = rows.numberIfAny(7), seen.boundaryAgreement = rows.numberIfAny(8);
    runOf(rows.integer(0), database, places, runs).rooms.push_back(std::move(seen));
  }
}

}  // namespace

std::vector<HistoryRun> readRuns(Database& database, const std::string& site,
                                 const std::vector<std::string>& figures) {
  std::vector<HistoryRun> runs;
  const Transaction all(database, Transaction::Access::reads);
  const RunPlaces places = readRuns(database, site, runs);
  for (const std::string& name : figures) readFigures(database, site, name, places, runs);
  return runs;
}

SiteHistory readHistory(Database& database, const std::string& site) {
  SiteHistory history;
  history.site = site;
  const Transaction all(database, Transaction::Access::reads);
  const RunPlaces places = readRuns(database, site, history.runs);
  readFigures(database, site, "%", places, history.runs);
  readSightings(database, site, places, history.runs);
  history.ledger = readLedger(database, site);
  return history;
}

SiteFile readLedger(Database& database, const std::string& site) {
  Statement row(database, "SELECT ledger FROM site WHERE name = ? AND ledger <> ''");
  return row.with(site).step() ? parseSiteJson(row.text(0), database.file()) : SiteFile();
}

}  // namespace roomgraph
