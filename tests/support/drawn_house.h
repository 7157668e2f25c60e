#pragma once
#include <string>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph::test {

/** A house of upright boxes, for maps and areas that are known by construction. */
struct House {
  struct RoomBox {
    Point low, high;
    bool isCorridor = false;
    bool isArea = true;  ///< else it is free, but in no area
  };
  struct DoorBox {
    std::size_t a, b;  ///< rooms
    Point place;
  };
  std::vector<RoomBox> rooms;
  std::vector<DoorBox> doors;
  double bendAt = 1e9;  ///< what lies beyond this x is turned and shifted [m]
  double bend = 0;      ///< about (bendAt, 5) [rad]
  Point shift;          ///< [m]

  /** Where a place of the house is drawn. */
  Point drawn(Point p) const;
};

/** A corridor of 20 m with five rooms of different widths on each side; room 0 is the corridor. */
House house();

/** A run that draws the house, in a frame of its own: `pose` is run <- house. */
Run runOf(const House& house, const std::string& name, const Transform2D& pose);

}  // namespace roomgraph::test
