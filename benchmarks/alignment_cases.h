#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** A map file; pictures without a resolution are read at `resolution` [m per cell]. */
struct MapSource {
  std::string file;
  double resolution = 0.05;
  std::string site;  ///< equal for maps of one building
};

/** How a pair is cut so that only a strip of it overlaps. */
struct StripCut {
  double share = 0;      ///< of the smaller map's free space that is in both
  bool isAlong = false;  ///< the strip runs along the longer axis of the common space, not across
};

/** Two maps and what must come out. */
struct AlignmentCase {
  std::string group, name;
  std::size_t a = 0, b = 0;          ///< of the sources
  std::optional<Transform2D> truth;  ///< a <- b; none for different buildings
  std::vector<Point> places;         ///< of b, where displacement is measured; else all walls of b
  double within = 0.8;               ///< mean displacement allowed [m]
  double withinAngle = 5;            ///< [deg]
  std::optional<StripCut> cut;
};

struct AlignmentCases {
  std::vector<MapSource> sources;
  std::vector<AlignmentCase> cases;

  std::size_t add(const MapSource& source);  ///< its index, also if it is there already
};

/** The pixel of the Halmstad maps, which state none: doors are then 0.8 m wide. */
constexpr double kHalmstadResolution = 0.02;

void addHalmstad(const std::string& data, AlignmentCases& cases);
void addStrands(const std::string& data, AlignmentCases& cases);
void addSimulated(const std::string& data, AlignmentCases& cases);
/** Pairs of the groups that are there already, cut to strips. */
void addStrips(AlignmentCases& cases);
void addDifferent(const std::string& data, AlignmentCases& cases);

}  // namespace roomgraph
