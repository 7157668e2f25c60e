#pragma once
#include "roomgraph/repair/carry_things.h"

namespace roomgraph::test {

/** The things of a file as a map has them that is turned and shifted by `motion`. */
inline std::vector<CarriedThing> carriedBy(const Transform2D& motion, const MarkedFile& file) {
  std::vector<CarriedPlace> carried;
  for (const Place& place : file.places) {
    CarriedPlace& there = carried.emplace_back();
    there.pose = motion * place.pose, there.state = CarryState::carried, there.error = 0.05;
  }
  return carriedThings(file, carried, motion);
}

/** The only file that is written, of things on a map that is turned and shifted by `motion`. */
inline std::string textBy(const Transform2D& motion, const MarkedFile& file) {
  return file.write(carriedBy(motion, file), {}).at(0).bytes;
}

}  // namespace roomgraph::test
