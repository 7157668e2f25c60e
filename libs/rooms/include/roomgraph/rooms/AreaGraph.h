#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/base/Ids.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

using AreaId = Id<struct AreaTag>;        ///< a place in AreaGraph::areas
using PassageId = Id<struct PassageTag>;  ///< a place in AreaGraph::passages

/** A room or a piece of corridor. */
struct Area {
  RoomId room;                      ///< of the room graph; none for a piece of corridor
  Polygon polygon;                  ///< its corners are obstacles [m, map frame]
  Point widestPlace;                ///< centre of the largest disc that fits in
  double inscribedRadius = 0;       ///< of that disc [m]
  std::vector<PassageId> passages;  ///< ascending
  /** How much of it was seen: the share of what bounds it that is wall and not the edge of the
   *  unknown, beside the mean of the map, from 0 to 1. None with rooms of one alpha. */
  std::optional<double> seen = {};

  [[nodiscard]] bool isRoom() const { return bool(room); }  ///< else corridor
};

/** Why an opening was taken for one. The wall of an end goes on where no cell beyond it, in line
 *  with the opening and as far as half of its width, is free. */
enum class PassageReason : std::uint8_t {
  wallOnBothSides,  ///< it is narrow beside both areas or doors, and at both ends the wall goes on
  wallOnOneSide,    ///< the same, at one end only: a door in the corner of a room
  narrowing,        ///< narrow beside both areas, between corners or things that stick out
  mouth,            ///< as wide as the narrower area, which opens into a wider one
  unseenSide        ///< an end is no wall, but the edge of what was seen
};

/** How sure it is that a passage is a door, and what speaks for it. */
struct PassageEvidence {
  /** 0 to 1: the geometric mean of how much narrower it is than the narrower area, and than the
   *  widest door; 0 where it is as wide as one of these. In a wall that goes on at both ends, up to
   *  SplitAtDoorsOptions::corridorDoor, the latter alone. Where it is narrower than the narrowest
   *  room, as gaps beside furniture are, only that share of it. As many ends count as are wall, and
   *  half of it where only one side is an area: beams also go through windows. */
  double confidence = 0;
  PassageReason reason = PassageReason::narrowing;
};

/** An opening between two obstacles in which two areas meet, or through which beams have seen
 *  space, but too little of it for an area. */
struct Passage {
  AreaId a, b;       ///< the smaller one first; b is none for space that is in no area
  Point from, to;    ///< its two ends, which are obstacles [m, map frame]
  double width = 0;  ///< distance of its ends [m]
  PassageEvidence evidence = {};
  [[nodiscard]] Point middle() const { return midpoint(from, to); }  ///< [m, map frame]
};

/** As many areas can be told apart in 16 bits. */
constexpr std::size_t kMaxLabelledAreas = 65535;

/** The free space of a map in areas that meet in passages (Area Graph; Hou et al. 2019). */
struct AreaGraph {
  std::vector<Area> areas;        ///< rooms in the order of the room graph, then corridors
  std::vector<Passage> passages;  ///< ordered by a, b and place
  /** Per cell of the map, row-major, row 0 lowest: 1 + the index of its area; 0 for none. */
  std::vector<std::uint16_t> labels;
};

}  // namespace roomgraph
