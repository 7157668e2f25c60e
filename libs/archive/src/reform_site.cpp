#include "reform_site.h"

#include <set>

#include "roomgraph/base/sequences.h"
#include "roomgraph/ledger/name_rooms.h"

namespace roomgraph {
namespace {

std::size_t seenBy(const SiteRoom& room) {
  return countIf(room.runs, [](const RoomInRun& in) { return in.sighting == RoomSighting::seen; });
}

constexpr std::size_t kLeastAgreeing = 3;  // of two that differ, nothing says which is right

void unplaceAll(Database& database, std::int64_t site) {
  for (const char* table : {"figure", "sighting"})
    database.run(
        std::string("DELETE FROM ") + table + " WHERE run IN (SELECT id FROM run WHERE site = ?)",
        site);
  database.run(
      "UPDATE run SET state = 'other site', reason = 'lies in another site than later runs, which "
      "agree with each other' WHERE site = ? AND state = 'placed'",
      site);
  database.run("UPDATE site SET ledger = '' WHERE id = ?", site);
}

}  // namespace

bool hasPlaced(Database& database, std::int64_t site, const Comparison& comparison) {
  constexpr char kPlaced[] =
      "SELECT count(*) FROM run WHERE site = ? AND sha256 = ? AND state = 'placed'";
  return anyOf(comparison.runs, [&](const ComparedRun& run) {
    return database.number(kPlaced, site, run.sha256) > 0;
  });
}

void nameKnownRooms(Comparison& comparison, SiteFile& ledger, const std::string& name) {
  auto [rooms, file] = nameRooms(comparison.rooms, ledger, name);
  const auto known = mapped(ledger.rooms, &SiteRoom::id);
  std::set<std::string> dropped;
  for (const SiteRoom& room : rooms)
    if (comparison.runs.size() > 2 && seenBy(room) < 2 && !contains(known, room.id))
      dropped.insert(room.id);
  const auto isDropped = [&](const auto& room) { return dropped.count(room.id) > 0; };
  eraseIf(rooms, isDropped);
  eraseIf(file.rooms, isDropped);
  comparison.rooms = std::move(rooms);
  ledger = std::move(file);
}

void reformSite(Database& database, std::int64_t site, const Comparison& comparison) {
  const auto& runs = comparison.runs;
  const auto placed =
      database.number("SELECT count(*) FROM run WHERE site = ? AND state = 'placed'", site);
  if (placed == 0 || runs.size() < kLeastAgreeing || std::int64_t(runs.size()) <= placed ||
      hasPlaced(database, site, comparison))
    return;
  unplaceAll(database, site);
  for (const ComparedRun& run : runs)
    database.run("UPDATE run SET state = 'placed' WHERE site = ? AND sha256 = ?", site, run.sha256);
}

bool areRoomsOutvoted(Database& database, std::int64_t site, const Comparison& comparison) {
  if (comparison.runs.size() < kLeastAgreeing) return false;
  const auto witnesses = database.number(
      "SELECT count(DISTINCT run) FROM sighting JOIN run ON sighting.run = run.id WHERE run.site = "
      "?",
      site);
  return witnesses < std::int64_t(comparison.runs.size());
}

}  // namespace roomgraph
