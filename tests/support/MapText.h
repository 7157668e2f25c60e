#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph::test {

/** A pair of room names, the smaller one first. */
using NamePair = std::pair<char, char>;

/** What must come out of a map, in a person's words. */
struct Expected {
  /** By "rooms", "borders", "dead ends", "junctions", "rings", "corridors", "holes". */
  std::map<std::string, int> counts;
  std::set<NamePair> joined;        ///< rooms with a way between them through no third room
  std::map<char, int> exits;        ///< border vertices of a room, where the text says so
  std::set<std::string> noteCodes;  ///< all of them
};

/** A map drawn in text: '#' is occupied, '.' free, '?' unknown. A capital letter is free and names
 *  the room it lies in. */
struct MapText {
  std::string name, sentence;
  double resolution = 1;
  Point origin;
  int width = 0, height = 0;
  std::vector<char> cells;  ///< row-major, row 0 lowest; of '#', '.', '?'
  std::map<char, Point> names;
  std::vector<std::vector<std::string>> settings;  ///< section, key, value
  std::string preset = "default";
  /** What a person would say otherwise than the default way to find rooms, or than a disc of one
   *  size without clutter; empty for nothing. */
  std::string differsByDoors, differsByDisc;
  std::string notResampled;  ///< why it means something else in smaller cells; empty if it does not
  Expected expected;
};

/** Rows from the top to the bottom of the drawing. Throws std::runtime_error for a stray letter. */
MapText drawn(const std::vector<std::string>& rows, double resolution);

/** Reads tests/maps/`name`.map: a sentence, lines of "key: value", then "drawing:" and the rows. */
MapText readMapText(const std::string& name);

/** The names of all drawings, in alphabetical order. */
std::vector<std::string> mapNames();

GridFrame frameOf(const MapText& text);
GreyMap greyMap(const MapText& text);
Grid gridOf(const MapText& text);
ExtractOptions optionsOf(const MapText& text);
bool hasUnknown(const MapText& text);

/** The drawing again, for messages. */
std::string picture(const MapText& text);

}  // namespace roomgraph::test
