#include "roomgraph/mrpt_plugin/draw_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "roomgraph/mrpt_plugin/colours.h"
#include "sample_graph.h"

namespace roomgraph {
namespace {

using ColourKey = std::tuple<int, int, int>;

ColourKey key(Colour c) { return {c.red, c.green, c.blue}; }

viz::CSetOfTriangles::Ptr part(const viz::CSetOfObjects::Ptr& drawing, const std::string& name) {
  return std::dynamic_pointer_cast<viz::CSetOfTriangles>(drawing->getByName(name));
}

std::set<ColourKey> coloursOf(const viz::CSetOfTriangles& triangles) {
  std::set<ColourKey> colors;
  for (std::size_t i = 0; i < triangles.getTrianglesCount(); ++i) {
    viz::TTriangle t;
    triangles.getTriangle(i, t);
    for (const auto& v : t.vertices) colors.insert({v.xyzrgba.r, v.xyzrgba.g, v.xyzrgba.b});
  }
  return colors;
}

/** Of all triangles together, seen from above. */
double areaOf(const viz::CSetOfTriangles& triangles) {
  double total = 0;
  for (std::size_t i = 0; i < triangles.getTrianglesCount(); ++i) {
    viz::TTriangle t;
    triangles.getTriangle(i, t);
    const auto at = [&](int k) {
      return Point{t.vertices[k].xyzrgba.pt.x, t.vertices[k].xyzrgba.pt.y};
    };
    total += std::abs(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return total;
}

TEST(DrawGraph, hasAllPartsByName) {
  const auto drawing = drawGraph(sampleGraph());
  for (const char* name :
       {"map", "rooms", "room outlines", "ways in rooms", "corridors", "vertices", "room numbers"})
    EXPECT_TRUE(drawing->getByName(name)) << name;
  EXPECT_EQ(drawing->size(), 7U);
}

TEST(DrawGraph, floorsCoverTheRoomsInTheirColours) {
  const CRoomGraph sample = sampleGraph();
  const auto floors = part(drawGraph(sample), "rooms");
  ASSERT_TRUE(floors);
  double total = 0;
  std::set<ColourKey> expected;
  for (std::size_t i = 0; i < sample.file.graph.rooms.size(); ++i) {
    total += area(sample.file.graph.rooms[i].shape.polygon);
    expected.insert(key(roomColour(i)));
  }
  EXPECT_NEAR(areaOf(*floors), total, 1e-3);
  EXPECT_EQ(coloursOf(*floors), expected);
}

TEST(DrawGraph, eachKindOfVertexHasItsColour) {
  const CRoomGraph sample = sampleGraph();
  const auto discs = part(drawGraph(sample), "vertices");
  ASSERT_TRUE(discs);
  std::set<ColourKey> expected{key(kRimColour)};
  for (const Vertex& vertex : sample.file.graph.graph.vertices())
    expected.insert(key(vertexColour(vertex.kind)));
  EXPECT_EQ(expected.size(), 6U);
  EXPECT_EQ(coloursOf(*discs), expected);
}

TEST(DrawGraph, waysLieWhereTheirPathsAre) {
  CRoomGraph one;
  one.file.graph.graph = TopologyGraph(
      {{{100, 50}, 1, VertexKind::deadEnd, {}}, {{110, 50}, 1, VertexKind::deadEnd, {}}},
      {{VertexId(0), VertexId(1), {{{100, 50}, {110, 50}}, {}, 10, 1}, {}}});
  const auto drawing = drawGraph(one);
  const auto box = drawing->getBoundingBox();
  // The discs of the vertices reach a little farther.
  EXPECT_NEAR(box.min.x, 100, 0.2);
  EXPECT_NEAR(box.max.x, 110, 0.2);
  EXPECT_NEAR(box.min.y, 50, 0.2);
  EXPECT_NEAR(box.max.y, 50, 0.2);
  const auto corridor = part(drawing, "corridors");
  ASSERT_TRUE(corridor);
  EXPECT_EQ(corridor->getTrianglesCount(), 2U);
  EXPECT_EQ(coloursOf(*corridor), std::set<ColourKey>{key(kCorridorColour)});
}

TEST(DrawGraph, theMapLiesUnderTheGraphAndKeepsItsWalls) {
  CRoomGraph sample = sampleGraph();
  const auto plane =
      std::dynamic_pointer_cast<viz::CTexturedPlane>(drawGraph(sample)->getByName("map"));
  ASSERT_TRUE(plane);
  float left, right, bottom, top;
  plane->getPlaneCorners(left, right, bottom, top);
  EXPECT_FLOAT_EQ(right - left, 24);
  EXPECT_FLOAT_EQ(top - bottom, 16);
  EXPECT_EQ(plane->getTextureImage().getWidth(), 240U);
  // The pillar, by column and row of the map from below.
  EXPECT_EQ(plane->getTextureImage().at<std::uint8_t>(80, 40), kOccupiedGrey);
  EXPECT_EQ(plane->getTextureImage().at<std::uint8_t>(60, 40), kFreeGrey);
  EXPECT_EQ(plane->getTextureImage().at<std::uint8_t>(2, 2), kUnknownGrey);
}

TEST(DrawGraph, aLargeMapIsDrawnCoarserAndKeepsThinWalls) {
  CRoomGraph graph;
  const int side = 2 * kMostTexels + 1;
  graph.map = Grid{{side, 3, 0.05, {0, 0}}, std::vector<State>(3 * std::size_t(side), State::free)};
  graph.map->cells[1001] = State::occupied;
  const auto plane =
      std::dynamic_pointer_cast<viz::CTexturedPlane>(drawGraph(graph)->getByName("map"));
  ASSERT_TRUE(plane);
  EXPECT_LE(plane->getTextureImage().getWidth(), std::size_t(kMostTexels));
  EXPECT_EQ(plane->getTextureImage().at<std::uint8_t>(1001 / 3, 0), kOccupiedGrey);
}

TEST(DrawGraph, nothingIsDrawnOfAnEmptyGraph) { EXPECT_TRUE(drawGraph({})->empty()); }

}  // namespace
}  // namespace roomgraph
