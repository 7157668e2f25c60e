#include "extraction_notes.h"

#include <algorithm>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

Note clutterNote(const std::vector<Clutter>& clutter) {
  const auto largest =
      std::max_element(clutter.begin(), clutter.end(),
                       [](const Clutter& a, const Clutter& b) { return a.size < b.size; });
  return {"clutter",
          formatted("%zu free-standing obstacles up to %.2f m across are taken for clutter and do "
                    "not split rooms",
                    clutter.size(), largest->size),
          std::array<double, 2>{largest->center.x, largest->center.y}};
}

/** Free width of the largest disc in an area [m]. */
double freeWidth(const Area& area, double resolution) {
  return 2 * (area.inscribedRadius - resolution / 2);
}

/** Where narrow regions outnumber the rooms, people miss them. */
void noteNarrowRegions(const Stages& s, Notes& notes) {
  const SplitAtDoorsOptions& options = s.options.splitAtDoors;
  if (s.roomRadius > 0) return;
  const auto isNarrow = [&](const Area& a) {
    const double width = freeWidth(a, s.grid.frame.resolution);
    return !a.isRoom() && width < options.openRoomWidth &&
           area(a.polygon) <= options.maxElongation * width * width;
  };
  const auto count = countIf(s.areas.areas, isNarrow);
  if (count <= s.result.rooms.size()) return;
  notes.push_back(
      {"narrow_regions",
       formatted("%zu regions narrower than %.2f m are not closed by doors and count as corridor: "
                 "--set split_at_doors.open_room_width=%.2g makes rooms of them",
                 count, options.openRoomWidth, options.minRoomWidth)});
}

/** Slivers between single beams, hundreds on some maps, are not worth a word. */
void noteHalfSeen(const Stages& s, Notes& notes) {
  double largest = s.options.splitAtDoors.maxLeftoverArea;
  std::size_t count = 0;
  Point place;
  for (const Room& region : s.outlines.halfSeen()) {
    const double size = area(region.polygon);
    if (size < s.options.splitAtDoors.maxLeftoverArea) continue;
    ++count;
    if (size >= largest) largest = size, place = region.widestPlace;
  }
  if (count == 0) return;
  notes.push_back(
      {"half_seen",
       formatted("%zu region%s that beams saw in part, up to %.1f m2, %s neither room nor corridor",
                 count, count == 1 ? "" : "s", largest, count == 1 ? "is" : "are"),
       std::array<double, 2>{place.x, place.y}});
}

/** Whether free floor runs out of the map. Without unknown cells that is outside of a drawing. */
bool runsOut(const Grid& grid) {
  const auto isFreeAt = [&](int x, int y) { return grid.at({x, y}) == State::free; };
  bool isFree = false;
  for (int x = 0; x < grid.frame.width; ++x)
    isFree |= isFreeAt(x, 0) || isFreeAt(x, grid.frame.height - 1);
  for (int y = 0; y < grid.frame.height; ++y)
    isFree |= isFreeAt(0, y) || isFreeAt(grid.frame.width - 1, y);
  return isFree && !grid.has(State::unknown);
}

/** Whether there is more wall than floor, as where free and occupied are exchanged. */
bool isMostlyWall(const Grid& grid) {
  const auto count = [&](State s) { return std::count(grid.cells.begin(), grid.cells.end(), s); };
  return count(State::occupied) > count(State::free);
}

}  // namespace

Notes extractionNotes(const Stages& s) {
  Notes notes;
  const bool isEmpty = s.result.graph.vertices().empty();
  if (!s.cleared.clutter.empty()) notes.push_back(clutterNote(s.cleared.clutter));
  const bool isOpen = s.result.rooms.empty() && runsOut(s.grid);
  if (!isEmpty) noteHalfSeen(s, notes);
  if (!isEmpty && !isOpen) noteNarrowRegions(s, notes);
  const auto note = [&](const char* code, const char* text) { notes.push_back({code, text}); };
  if (!s.grid.has(State::free))
    note("no_free_cell", "the map has no free cell, so its graph is empty");
  else if (s.obstacles.cells.empty())
    note("no_obstacle", "the map has no obstacle, so there is nothing to keep clear of");
  else if (isOpen)
    note("open_edge",
         "free floor reaches the edge of the map and counts as outside: a margin of "
         "unknown cells closes it");
  else if (isEmpty)
    note("no_path", isMostlyWall(s.grid)
                        ? "no place of the map is wide enough for a path, and there is more wall "
                          "than floor: are free and occupied exchanged (negate in its yaml)?"
                        : "no place of the map is wide enough for a path");
  else if (s.result.rooms.empty())
    note("no_room", "the map has no room, only corridors");
  return notes;
}

}  // namespace roomgraph
