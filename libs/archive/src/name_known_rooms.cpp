#include "name_known_rooms.h"

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

}  // namespace roomgraph
