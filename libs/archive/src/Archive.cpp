#include "roomgraph/archive/Archive.h"

#include "Database.h"
#include "read_history.h"
#include "reform_site.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/version.h"
#include "roomgraph/report/site_json.h"
#include "schema.h"

namespace roomgraph {
namespace {

/** What is to be written of a run. */
struct Entry {
  HistoryRun run;
  const ComparedRun* compared = nullptr;  ///< none where it lies in no site of the others
  std::int64_t known = 0;  ///< its key where it is there already, and only its figures are new
};

const ComparedRun* findRun(const Comparison& comparison, const std::string& sha256) {
  for (const ComparedRun& run : comparison.runs)
    if (run.sha256 == sha256) return &run;
  return nullptr;
}

/** Names of files may have lost their folders when the comparison was saved. */
const LeftOutRun* findLeftOut(const Comparison& comparison, const std::string& file) {
  for (const LeftOutRun& run : comparison.leftOut)
    if (run.file == file) return &run;
  for (const LeftOutRun& run : comparison.leftOut)
    if (fileName(run.file) == fileName(file)) return &run;
  return nullptr;
}

std::string textOf(const std::vector<UsedOption>& options) {
  std::string text;
  for (const UsedOption& option : options)
    text += option.section + "." + option.name + "=" + option.value + "\n";
  return text;
}

std::int64_t siteOf(Database& database, const std::string& name) {
  database.run("INSERT OR IGNORE INTO site (name) VALUES (?)", name);
  return database.number("SELECT id FROM site WHERE name = ?", name);
}

/** Whether another program has changed the site since: the new run would not be told by all. */
bool isOutdated(Database& database, std::int64_t site, const Addition& addition) {
  const auto runs = database.number("SELECT count(*) FROM run WHERE site = ?", site);
  return addition.knownRuns && std::size_t(runs) != *addition.knownRuns;
}

/** The key of a run that is there, else 0. */
std::int64_t keyOf(Database& database, std::int64_t site, const std::string& sha256) {
  return database.number("SELECT id FROM run WHERE site = ? AND sha256 = ?", site, sha256);
}

bool hasTrustedError(Database& database, std::int64_t run) {
  return database.number("SELECT meaningful FROM figure WHERE run = ? AND name = ?", run,
                         kMapError) != 0;
}

/** Whether the compared runs are the site that is known: not where a known one was left out for
 *  lying elsewhere, and none remains. */
bool isKnownSite(Database& database, std::int64_t site, const Comparison& comparison) {
  if (hasPlaced(database, site, comparison)) return true;
  Statement known(database, "SELECT file FROM run WHERE site = ? AND state = 'placed'");
  known.with(site);
  while (known.step())
    if (const LeftOutRun* left = findLeftOut(comparison, known.text(0)))
      if (left->isOtherSite) return false;
  return true;
}

std::vector<Entry> newRuns(Database& database, std::int64_t site, const Addition& addition) {
  std::vector<Entry> runs;
  const Comparison& comparison = addition.comparison;
  for (HistoryRun run : addition.runs) {
    const auto isSame = [&](const Entry& entry) { return entry.run.sha256 == run.sha256; };
    if (keyOf(database, site, run.sha256) || anyOf(runs, isSame)) continue;
    if (const ComparedRun* compared = findRun(comparison, run.sha256)) {
      const bool isKnown = isKnownSite(database, site, comparison);
      run.reason = isKnown ? compared->reason : "lies in no site of the known runs";
      runs.push_back({run, isKnown ? compared : nullptr});
    } else if (const LeftOutRun* left = findLeftOut(comparison, run.file);
               left && left->isOtherSite) {
      run.reason = left->reason;
      runs.push_back({run});
    }
  }
  return runs;
}

/** The runs that are there, but had no figures to be trusted, or no place, when they came. */
void addStale(Database& database, std::int64_t site, const Comparison& comparison,
              std::vector<Entry>& runs) {
  if (!isKnownSite(database, site, comparison)) return;
  for (const ComparedRun& run : comparison.runs) {
    const std::int64_t key = keyOf(database, site, run.sha256);
    if (!key || !run.score || hasTrustedError(database, key)) continue;
    Entry stale;
    stale.compared = &run, stale.run.reason = run.reason, stale.known = key;
    runs.push_back(stale);
  }
}

std::string nameRoomsOf(Database& database, const std::string& name, std::int64_t site,
                        Comparison& comparison) {
  SiteFile ledger = readLedger(database, name);
  try {
    if (isKnownSite(database, site, comparison))
      nameKnownRooms(comparison, ledger, database.file());
  } catch (const DataError&) {
    if (!areRoomsOutvoted(database, site, comparison)) {
      comparison.rooms.clear();
      return database.file() +
             ": the rooms of the site cannot be found in these runs, or in several ways: they "
             "stay as they were";
    }
    ledger = {};
    nameKnownRooms(comparison, ledger, database.file());
  }
  database.run("UPDATE site SET ledger = ? WHERE id = ?", siteJson(ledger), site);
  return "";
}

std::int64_t writeComparison(Database& database, std::int64_t site, const Comparison& comparison) {
  const std::string options = textOf(comparison.options);
  database.run("INSERT OR IGNORE INTO settings (version, options) VALUES (?, ?)", version(),
               options);
  database.run(
      "INSERT INTO comparison (site, settings, verdict) "
      "SELECT ?, id, ? FROM settings WHERE version = ? AND options = ?",
      site, comparison.verdict, version(), options);
  return database.number("SELECT last_insert_rowid()");
}

void writeFigures(Database& database, std::int64_t key, const ComparedRun& run,
                  const Comparison& comparison) {
  Statement figure(database, "INSERT INTO figure VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (const Measure& one : figuresOf(run, comparison))
    figure
        .with(key, one.name, one.value, one.low, one.high, one.unit, one.support, one.isMeaningful)
        .step();
  Statement sighting(database, "INSERT INTO sighting VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const RoomSeen& one : roomsOf(run, comparison))
    sighting
        .with(key, one.room, nameOf(one.sighting), one.pieces, one.isMerged, one.doors, one.area,
              one.shift, one.boundaryAgreement)
        .step();
}

void write(Database& database, const Entry& entry, std::int64_t site, std::int64_t comparison,
           const Comparison& found) {
  std::int64_t key = entry.known;
  if (key) {
    database.run("UPDATE run SET comparison = ?, reason = ?, state = 'placed' WHERE id = ?",
                 comparison, entry.run.reason, key);
    database.run("DELETE FROM figure WHERE run = ?", key);
    database.run("DELETE FROM sighting WHERE run = ?", key);
  } else {
    const HistoryRun& run = entry.run;
    database.run(
        "INSERT INTO run (site, sha256, robot, time, file, state, reason, comparison) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        site, run.sha256, run.robot, run.time, run.file, entry.compared ? "placed" : "other site",
        run.reason, comparison);
    key = database.number("SELECT last_insert_rowid()");
  }
  if (entry.compared) writeFigures(database, key, *entry.compared, found);
}

}  // namespace

Archive::Archive(const std::string& file, Access access)
    : database_(std::make_unique<Database>(file, access == Access::orNew)) {
  // What an answer from the disk is worth must not depend on what reads at the same time. Where
  // another program is just doing the same, its mode will do.
  if (!database_->isReadOnly()) database_->tryRun("PRAGMA journal_mode = WAL");
  database_->run("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
  migrate(*database_);
}

Archive::~Archive() = default;

std::vector<std::string> Archive::sites() const {
  std::vector<std::string> names;
  Statement rows(*database_, "SELECT name FROM site ORDER BY name");
  while (rows.step()) names.push_back(rows.text(0));
  return names;
}

std::vector<HistoryRun> Archive::runs(const std::string& site) const {
  return readRuns(*database_, site, {kBreaks, kMapError});
}

bool Archive::knows(const std::string& site, const std::string& sha256) const {
  return database_->number(
             "SELECT count(*) FROM run JOIN site ON run.site = site.id "
             "WHERE site.name = ? AND sha256 = ?",
             site, sha256) > 0;
}

SiteHistory Archive::history(const std::string& site) const {
  return readHistory(*database_, site);
}

Added Archive::record(const Addition& addition) {
  Database& database = *database_;
  Transaction transaction(database);
  const std::int64_t site = siteOf(database, addition.site);
  if (isOutdated(database, site, addition)) return {0, "", true};
  reformSite(database, site, addition.comparison);
  std::vector<Entry> runs = newRuns(database, site, addition);
  if (runs.empty()) return {};
  Added added;
  added.runs = runs.size();
  addStale(database, site, addition.comparison, runs);
  Comparison comparison = addition.comparison;
  added.roomsFailed = nameRoomsOf(database, addition.site, site, comparison);
  const std::int64_t id = writeComparison(database, site, comparison);
  for (const Entry& run : runs) write(database, run, site, id, comparison);
  for (const ComparedRun& run : comparison.runs)
    database.run("INSERT INTO compared SELECT ?, id FROM run WHERE site = ? AND sha256 = ?", id,
                 site, run.sha256);
  transaction.commit();
  return added;
}

}  // namespace roomgraph
