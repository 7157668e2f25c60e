#pragma once
#include <string>
#include <vector>

#include "roomgraph/ledger/SiteRoom.h"

namespace roomgraph {

/** A room that a file of names knows. */
struct KnownRoom {
  std::string id;    ///< never given to another room
  std::string name;  ///< the id, or what the user made of it
  bool isCorridor = false;
  Point center;  ///< [m, frame of the file], as all that follows
  double area = 0;
  Polygon polygon;
  std::vector<SiteDoor> doors;
};

/** What is kept of a site from one comparison to the next: a file of format "roomgraph/site". Its
 *  frame is that of the comparison that made it, and stays. */
struct SiteFile {
  std::vector<KnownRoom> rooms;  ///< rooms, then corridors, each in the order they were first seen
  int nextRoom = 1, nextCorridor = 1;  ///< numbers that no id has had yet
};

}  // namespace roomgraph
