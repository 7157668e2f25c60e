#pragma once
#include <string>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Where the frame of a map lies on Earth: x is eastward, y northward, by the radii of curvature of
 *  WGS84 there (equirectangular). */
class OsmOrigin {
 public:
  /** @param latitude, longitude [degrees] */
  explicit OsmOrigin(double latitude = 0, double longitude = 0);

  Point placeAt(double latitude, double longitude) const;  ///< [m]
  /** Degrees with nine digits, 0.1 mm; the same on every machine and in every locale. */
  std::string latitudeText(Point place) const;
  std::string longitudeText(Point place) const;

 private:
  double latitude_, longitude_;
  double eastRadius_, northRadius_;  // [m]
};

}  // namespace roomgraph
