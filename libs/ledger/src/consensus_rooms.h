#pragma once
#include <vector>

#include "match_areas.h"
#include "roomgraph/base/ForEach.h"

namespace roomgraph {

// In:   SiteAreas
// Out:  ConsensusRooms
// Next: siteRooms

/** So many runs, the most trusted, say what a room is: the cost grows with the runs, and not with
 *  their pairs. */
constexpr std::size_t kMaxVoters = 12;

/** The rooms that the runs agree on, and what each is in each run. */
struct ConsensusRooms {
  /** Where the shape of a room comes from. */
  struct Source {
    std::size_t run = 0, area = 0;
  };
  RoomSet rooms;
  std::vector<Source> sources;                  ///< of each room
  std::vector<std::vector<AreaMatch>> matches;  ///< by run, then room
};

/** Each area of the most trusted runs is a candidate, and each run that has an area like it votes
 *  for it with its weight. The candidate with most votes becomes a room; those that overlap it do
 *  not; and so on. A candidate needs the votes of two runs or of half of all weight. Then all runs
 *  are matched, and what areas are left become rooms, too, where they overlap none and the runs
 *  that have them are not much less trusted than the others: a bent map adds none. Narrow ends of
 *  corridors that lead nowhere are no candidates. Does not depend on the order of the runs but in
 *  exact ties. O(runs * rooms * samples). */
ConsensusRooms consensusRooms(const SiteAreas& site, const ForEach& forEach);

}  // namespace roomgraph
