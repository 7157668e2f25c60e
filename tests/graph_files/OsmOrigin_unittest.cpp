#include "roomgraph/graph_files/OsmOrigin.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace roomgraph {
namespace {

TEST(OsmOrigin, placesComeBackFromDegrees) {
  for (const double latitude : {0.0, 53.2, -33.9}) {
    const OsmOrigin origin(latitude, 8.8);
    const Point there{123.456, -78.9};
    const Point back = origin.placeAt(std::atof(origin.latitudeText(there).c_str()),
                                      std::atof(origin.longitudeText(there).c_str()));
    EXPECT_LT(distance(there, back), 2e-4) << latitude;
  }
}

TEST(OsmOrigin, degreesAreThoseOfWgs84) {
  // A minute of latitude is 1842.9 m on the equator, one at 45 degrees 1852.2 m; one of longitude
  // there 1314.2 m.
  EXPECT_NEAR(OsmOrigin().placeAt(1 / 60.0, 0).y, 1842.9, 0.1);
  EXPECT_NEAR(OsmOrigin(45, 0).placeAt(45 + 1 / 60.0, 0).y, 1852.2, 0.1);
  EXPECT_NEAR(OsmOrigin(45, 0).placeAt(45, 1 / 60.0).x, 1314.2, 0.1);
  EXPECT_EQ(OsmOrigin().longitudeText({-1, 0}), "-0.000008983");
}

}  // namespace
}  // namespace roomgraph
