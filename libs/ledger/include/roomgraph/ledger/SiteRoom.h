#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

/** Whether a run knows a room of the site. */
enum class RoomSighting {
  seen,       ///< one of its areas is this room, or (without pieces) its floor is there, but drawn
              ///< as other areas or as none
  gone,       ///< it has looked there, and there is no floor
  unvisited,  ///< it has not looked there
};

[[nodiscard]] constexpr std::array<const char*, 3> enumNames(RoomSighting) {
  return {"seen", "gone", "unvisited"};
}

/** What one run says of a room of the site. All figures are against the consensus of the runs that
 *  have seen it. */
struct RoomInRun {
  std::string run;                                  ///< name
  RoomSighting sighting = RoomSighting::unvisited;  ///< what the run shows of it
  int pieces = 0;                           ///< areas of the run that make it up; 2 or more: split
  bool isMerged = false;                    ///< its area holds another room of the site, too
  std::optional<double> shift;              ///< of its middle [m]
  std::optional<double> areaChange;         ///< share, 0.1 for 10 % larger
  std::optional<double> boundaryAgreement;  ///< share of its outline that others draw, too
  std::optional<double> lengthError;        ///< of a corridor, end to end; longer: positive [m]
  /** Its doors where others have a wall, and those of the consensus where it has one. */
  int doorsGained = 0, doorsLost = 0;
};

/** An opening of a room that most runs have. */
struct SiteDoor {
  Point place;       ///< [m, site frame]
  double width = 0;  ///< [m]
  std::string to;    ///< id of the room behind it; empty for none
  /** Names of the runs that have it, and of those that have a wall across it; by name. */
  std::vector<std::string> seenIn{}, lostIn{};
};

/** A room or corridor of the site, over all runs. */
struct SiteRoom {
  std::string id;           ///< stays the same from call to call where names are kept
  std::string name;         ///< given by the user; else the id
  bool isCorridor = false;  ///< else a room
  Point center;             ///< [m, site frame]
  Polygon polygon;  ///< as that run draws it that the others agree with most [m, site frame]
  double area = 0;  ///< median over the runs that have seen it all [m2]
  std::vector<SiteDoor> doors;  ///< to other rooms
  std::vector<RoomInRun> runs;  ///< in the order of Comparison::runs
};

}  // namespace roomgraph
