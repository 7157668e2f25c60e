#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

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

/** Reads version 1. Fields that it does not know are skipped, and lost when the file is written
 *  anew. A room without a name is named by its id; doors to rooms that are not there lead nowhere.
 *  @throws DataError with one line (`name` of the file, place, problem, remedy) where it is no such
 *  file, or damaged. */
SiteFile parseSiteJson(const std::string& text, const std::string& name);

/** Its text: one room per line, so that names are easy to edit. Places are rounded to 0.1 mm. */
std::string siteJson(const SiteFile& file);

}  // namespace roomgraph
