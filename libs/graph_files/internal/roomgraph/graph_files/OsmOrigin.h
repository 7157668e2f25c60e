#pragma once
#include <string>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Where the frame of a map lies on Earth: x is eastward, y northward, by the radii of curvature of
 *  WGS84 at its root (equirectangular). */
class OsmOrigin {
 public:
  static constexpr double kFlat = 1e5;  ///< how far from its root the Earth is flat [m]
  /** Tags of a root that lies elsewhere on the map than at (0, 0): where [m]. */
  static constexpr const char *kRootX = "roomgraph:x", *kRootY = "roomgraph:y";

  /** @param latitude, longitude of the root [degrees]
   *  @param root its place on the map */
  explicit OsmOrigin(double latitude = 0, double longitude = 0, Point root = {});

  const Point& root() const { return root_; }
  Point placeAt(double latitude, double longitude) const;  ///< [m]
  /** Degrees with nine digits, 0.1 mm; the same on every machine and in every locale. */
  std::string latitudeText(Point place) const;
  std::string longitudeText(Point place) const;

 private:
  double latitude_, longitude_;
  Point root_;
  double eastRadius_, northRadius_;  // [m]
};

}  // namespace roomgraph
