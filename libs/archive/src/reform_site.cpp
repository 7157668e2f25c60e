#include "reform_site.h"

#include <algorithm>
#include <set>

#include "roomgraph/ledger/name_rooms.h"

namespace roomgraph {
namespace {

std::size_t seenBy(const SiteRoom& room) {
  return std::size_t(std::count_if(room.runs.begin(), room.runs.end(), [](const RoomInRun& in) {
    return in.sighting == RoomSighting::seen;
  }));
}

constexpr std::size_t kLeastAgreeing = 3;  // of two that differ, nothing says which is right

std::int64_t countOf(Database& database, const char* sql, std::int64_t site) {
  Statement found(database, sql);
  return found.with(site).step() ? found.integer(0) : 0;
}

bool isPlaced(Database& database, std::int64_t site, const std::string& sha256) {
  Statement found(database, "SELECT 1 FROM run WHERE site = ? AND sha256 = ? AND state = 'placed'");
  return found.with(site, sha256).step();
}

void unplaceAll(Database& database, std::int64_t site) {
  for (const char* table : {"figure", "sighting"})
    Statement(database, std::string("DELETE FROM ") + table +
                            " WHERE run IN (SELECT id FROM run WHERE site = ?)")
        .with(site)
        .run();
  Statement(database,
            "UPDATE run SET state = 'other site', reason = 'lies in another site than later runs, "
            "which agree with each other' WHERE site = ? AND state = 'placed'")
      .with(site)
      .run();
  Statement(database, "UPDATE site SET ledger = '' WHERE id = ?").with(site).run();
}

}  // namespace

void nameKnownRooms(Comparison& comparison, SiteFile& ledger, const std::string& name) {
  auto [rooms, file] = nameRooms(comparison.rooms, ledger, name);
  const auto isKnown = [&](const SiteRoom& room) {
    return std::any_of(ledger.rooms.begin(), ledger.rooms.end(),
                       [&](const KnownRoom& known) { return known.id == room.id; });
  };
  std::set<std::string> dropped;
  for (const SiteRoom& room : rooms)
    if (comparison.runs.size() > 2 && seenBy(room) < 2 && !isKnown(room)) dropped.insert(room.id);
  const auto isDropped = [&](const auto& room) { return dropped.count(room.id) > 0; };
  rooms.erase(std::remove_if(rooms.begin(), rooms.end(), isDropped), rooms.end());
  file.rooms.erase(std::remove_if(file.rooms.begin(), file.rooms.end(), isDropped),
                   file.rooms.end());
  comparison.rooms = std::move(rooms);
  ledger = std::move(file);
}

void reformSite(Database& database, std::int64_t site, const Comparison& comparison) {
  const auto& runs = comparison.runs;
  const auto placed =
      countOf(database, "SELECT count(*) FROM run WHERE site = ? AND state = 'placed'", site);
  if (placed == 0 || runs.size() < kLeastAgreeing || std::int64_t(runs.size()) <= placed) return;
  if (std::any_of(runs.begin(), runs.end(),
                  [&](const ComparedRun& run) { return isPlaced(database, site, run.sha256); }))
    return;
  unplaceAll(database, site);
  for (const ComparedRun& run : runs)
    Statement(database, "UPDATE run SET state = 'placed' WHERE site = ? AND sha256 = ?")
        .with(site, run.sha256)
        .run();
}

bool areRoomsOutvoted(Database& database, std::int64_t site, const Comparison& comparison) {
  if (comparison.runs.size() < kLeastAgreeing) return false;
  const auto witnesses = countOf(database,
                                 "SELECT count(DISTINCT run) FROM sighting JOIN run ON "
                                 "sighting.run = run.id WHERE run.site = ?",
                                 site);
  return witnesses < std::int64_t(comparison.runs.size());
}

}  // namespace roomgraph
