#include "roomgraph/repair/places_csv.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

const std::string kTable = "y,name,note,x,yaw\n2,\"dock, main\",kept,1,0.5\n\n-1.5,,,3,0\n";

TEST(PlacesCsv, columnsMayStandInAnyOrder) {
  const std::vector<Place> places = placesOfCsv(kTable, "goals.csv");
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].name, "dock, main");
  EXPECT_EQ(places[0].pose.shift(), (Point{1, 2}));
  EXPECT_EQ(places[0].pose.phi, 0.5);
  EXPECT_EQ(places[1].name, "line 4");
  EXPECT_EQ(placesOfCsv("x,y\n1,2\n", "goals.csv")[0].pose.phi, 0);
}

TEST(PlacesCsv, otherColumnsStay) {
  CarriedPlace there, nowhere;
  there.pose = Transform2D{4, 5, -1}, there.state = CarryState::carried, there.error = 0.0314;
  nowhere.reason = "not, seen";
  EXPECT_EQ(carriedCsv(kTable, "goals.csv", {there, nowhere}),
            "y,name,note,x,yaw,state,error_m,reason\n"
            "5.0000,\"dock, main\",kept,4.0000,-1.0000,carried,0.0314,\n"
            ",,,,,unseen,,\"not, seen\"\n");
}

TEST(PlacesCsv, whatIsNoPlaceIsRefused) {
  EXPECT_THROW(placesOfCsv("name,x\na,1\n", "goals.csv"), DataError);
  EXPECT_THROW(placesOfCsv("x,y\n1,\n", "goals.csv"), DataError);
  EXPECT_THROW(placesOfCsv("x,y\n1,2 m\n", "goals.csv"), DataError);
  EXPECT_THROW(placesOfCsv("x,y\n1,nan\n", "goals.csv"), DataError);
}

}  // namespace
}  // namespace roomgraph
