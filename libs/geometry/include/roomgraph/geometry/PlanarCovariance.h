#pragma once

namespace roomgraph {

/** How sure a pose in the plane is: of x, y [m] and phi [rad], in the frame of the map. */
struct PlanarCovariance {
  double xx = 0, yy = 0, pp = 0, xy = 0, xp = 0, yp = 0;
};

}  // namespace roomgraph
