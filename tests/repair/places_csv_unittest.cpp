#include <gtest/gtest.h>

#include "carried_by.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

const std::string kTable = "y,name,note,x,yaw\n2,\"dock, main\",kept,1,0.5\n\n-1.5,,,3,0\n";

TEST(PlacesCsv, columnsMayStandInAnyOrder) {
  const MarkedFile file = csvPlaces(kTable, "goals.csv");
  ASSERT_EQ(file.places.size(), 2u);
  EXPECT_EQ(file.places[0].name, "dock, main");
  EXPECT_EQ(file.places[0].pose.shift(), (Point{1, 2}));
  EXPECT_EQ(file.places[0].pose.phi, 0.5);
  EXPECT_EQ(file.things[1].name, "line 4");
  EXPECT_EQ(csvPlaces("x,y\n1,2\n", "goals.csv").places[0].pose.phi, 0);
}

TEST(PlacesCsv, columnsMayHaveLargeLetters) {
  const MarkedFile file = csvPlaces("Name,X,Y,Yaw\ndock,1,2,0.5\n", "goals.csv");
  EXPECT_EQ(file.things[0].name, "dock");
  EXPECT_EQ(file.places[0].pose.phi, 0.5);
  EXPECT_EQ(test::textBy({1, 0, 0}, file),
            "Name,X,Y,Yaw,state,error_m,reason\ndock,2.0000,2.0000,0.5000,carried,0.0500,\n");
}

TEST(PlacesCsv, otherColumnsStay) {
  CarriedThing there, nowhere;
  there.poses = {{4, 5, -1}}, there.error = 0.0314;
  nowhere.poses = {{7, 8, 0}}, nowhere.state = CarryState::unseen, nowhere.reason = "not, seen";
  const auto files = csvPlaces(kTable, "old/goals.csv").write({there, nowhere}, {});
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "goals.csv");
  EXPECT_EQ(files[0].bytes,
            "y,name,note,x,yaw,state,error_m,reason\n"
            "5.0000,\"dock, main\",kept,4.0000,-1.0000,carried,0.0314,\n"
            ",,,,,unseen,,\"not, seen\"\n");
}

TEST(PlacesCsv, otherCellsStayByteForByte) {
  const std::string more = ",-1.5,+49 30,\"a\",\"\",=1+1,-x, b ,\"c\nd\"";
  EXPECT_EQ(test::textBy({1, 0, 0},
                         csvPlaces("-name,x,y,a,\"b\",c,d,@e,f,g,h\n-2,1,2" + more, "goals.csv")),
            "-name,x,y,a,\"b\",c,d,@e,f,g,h,state,error_m,reason\n-2,2.0000,2.0000" + more +
                ",carried,0.0500,\n");
}

TEST(PlacesCsv, whatWasCarriedBeforeIsToldAnew) {
  EXPECT_EQ(test::textBy({1, 0, 0}, csvPlaces("state,x,y,reason\ngone,1,2,a wall\n", "goals.csv")),
            "state,x,y,reason,error_m\ncarried,2.0000,2.0000,,0.0500\n");
}

TEST(PlacesCsv, whatWasUnseenBeforeStaysInTheTable) {
  const MarkedFile file = csvPlaces("name,x,y,yaw\na,,,\nb,1,2,0\n", "goals.csv");
  ASSERT_EQ(file.things.size(), 2u);
  EXPECT_EQ(file.places.size(), 1u);
  EXPECT_EQ(test::textBy({1, 0, 0}, file),
            "name,x,y,yaw,state,error_m,reason\na,,,,unsure,,it has no place in its file\n"
            "b,2.0000,2.0000,0.0000,carried,0.0500,\n");
}

TEST(PlacesCsv, cellsBesideTheColumnsAreRefusedUnlessTheyAreEmpty) {
  EXPECT_EQ(csvPlaces("x,y\n1,2,\n", "goals.csv").places.size(), 1u);
  EXPECT_EQ(test::refusalOf([] { csvPlaces("x,y\n1,2,3\n", "goals.csv"); }),
            "goals.csv: has 3 cells in line 2, and 2 columns: name each column in its first line, "
            "and put texts with commas in quotes");
}

TEST(PlacesCsv, whatIsNoPlaceIsRefused) {
  EXPECT_THROW(csvPlaces("name,x\na,1\n", "goals.csv"), DataError);
  EXPECT_THROW(csvPlaces("x,y\n1,\n", "goals.csv"), DataError);
  EXPECT_THROW(csvPlaces("x,y\n1,2 m\n", "goals.csv"), DataError);
  EXPECT_THROW(csvPlaces("x,y\n1,nan\n", "goals.csv"), DataError);
  EXPECT_THROW(csvPlaces("x,y,X\n1,2,3\n", "goals.csv"), DataError);
  EXPECT_THROW(csvPlaces("name;x;y\na;1;2\n", "goals.csv"), DataError);
}

}  // namespace
}  // namespace roomgraph
