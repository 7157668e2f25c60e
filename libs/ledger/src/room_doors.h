#pragma once
#include <map>
#include <optional>
#include <vector>

#include "consensus_rooms.h"
#include "room_outlines.h"

namespace roomgraph {

/** Of one room: the doors that the runs agree on, and what each run has of them. */
struct RoomDoors {
  struct Door {
    Point from, end;                ///< [m, site frame], as the room's shape lies
    std::optional<std::size_t> to;  ///< the room behind it
    /** The runs that have it, and those that have a wall there; of the consensus only. */
    std::vector<std::size_t> seenIn{}, lostIn{};

    Point place() const { return midpoint(from, end); }
    double width() const { return distance(from, end); }
  };
  std::vector<Door> doors;        ///< of the consensus
  std::vector<int> gained, lost;  ///< by run; 0 where the room is not an area of its own
};

/** How each room lies in one run. */
struct RoomsInRun {
  std::vector<bool> isClean;    ///< the room is an area of its own, and can be measured
  std::vector<RoomMove> moves;  ///< run's drawing <- site
  std::map<std::size_t, RoomOutline> outlines{};  ///< there, of the rooms that it judges
};

/** Doors of two runs are one where they lead to the same room and are within 1.5 m, or else within
 *  0.8 m, after the move of the room, or of that behind it if that is smaller. A door is of the
 *  consensus where runs of more than half of the weight of those that know the place have it. A
 *  run has lost one where it has a wall across it, though it has not seen the other side, as of one
 *  that is shut; and gained one where half of the weight has a wall and knows both sides. Which
 *  narrow places are doors differs from run to run, and nothing has changed there.
 *  `inRuns`: by run. */
RoomDoors roomDoors(const SiteAreas& site, const ConsensusRooms& consensus, std::size_t room,
                    const std::vector<RoomsInRun>& inRuns);

}  // namespace roomgraph
