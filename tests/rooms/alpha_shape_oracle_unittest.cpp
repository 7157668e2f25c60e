// Rooms of a fixed alpha against CGAL's alpha shape. Its header is GPL: for tests only.
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "MapText.h"
#include "random_maps.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/rooms/find_rooms.h"
#include "roomgraph/rooms/trace_rooms.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vb = CGAL::Alpha_shape_vertex_base_2<Kernel>;
using Fb = CGAL::Alpha_shape_face_base_2<Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using AlphaShape = CGAL::Alpha_shape_2<Delaunay>;

using Side2 = std::pair<Point, Point>;

/** A room without its id: its area and the edges between it and what is not it. */
struct Outline {
  double area = 0;
  std::set<Side2> sides;
};

/** The bounded parts of what the alpha shape leaves empty. A single obstacle edge parts two of
 *  them, so the general mode decides; what encloses nothing does not count, as in the regularised
 *  one. Faces are collected one by one: CGAL's own extraction of rings splits or joins polygons
 *  that touch in a vertex as its walk happens to go. */
class Oracle {
 public:
  Oracle(const ObstacleCells& obstacles, double alpha) {
    std::vector<Kernel::Point_2> points;
    for (const Cell cell : obstacles.cells) points.emplace_back(cell.x, cell.y);
    shape_.set_mode(AlphaShape::GENERAL);
    shape_.make_alpha_shape(points.begin(), points.end());
    shape_.set_alpha(alpha);
  }

  std::vector<Outline> rooms() {
    std::vector<Outline> found;
    if (shape_.dimension() < 2) return found;
    int next = 0;
    for (auto face = shape_.all_faces_begin(); face != shape_.all_faces_end(); ++face)
      if (isEmpty(face) && !part_.count(face)) flood(face, next++);
    std::map<int, Outline> outlines;
    for (const auto& [face, part] : part_) {
      if (isUnbounded_.count(part)) continue;
      outlines[part].area += shape_.triangle(face).area();
      for (int i = 0; i < 3; ++i) addSide(face, i, part, outlines[part]);
    }
    for (auto& [part, outline] : outlines) found.push_back(std::move(outline));
    return found;
  }

 private:
  using Face = AlphaShape::Face_handle;

  bool isEmpty(Face face) const { return shape_.classify(face) == AlphaShape::EXTERIOR; }

  void flood(Face first, int part) {
    std::vector<Face> open{first};
    part_[first] = part;
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      if (shape_.is_infinite(face)) isUnbounded_.insert(part);
      for (int i = 0; i < 3; ++i) {
        const Face other = face->neighbor(i);
        const bool isOpen = shape_.is_infinite(AlphaShape::Edge(face, i)) ||
                            shape_.classify(face, i) == AlphaShape::EXTERIOR;
        if (!isEmpty(other) || part_.count(other) || !isOpen) continue;
        part_[other] = part;
        open.push_back(other);
      }
    }
  }

  void addSide(Face face, int i, int part, Outline& outline) const {
    const auto other = part_.find(face->neighbor(i));
    if (other != part_.end() && other->second == part) return;
    const auto a = face->vertex(AlphaShape::cw(i))->point();
    const auto b = face->vertex(AlphaShape::ccw(i))->point();
    outline.sides.insert(std::minmax(Point{a.x(), a.y()}, Point{b.x(), b.y()}));
  }

  AlphaShape shape_;
  std::map<Face, int> part_;
  std::set<int> isUnbounded_;
};

/** Our rooms in cells, in the same words. */
std::vector<Outline> ourRooms(const MapText& map, double alpha) {
  MapText inCells = map;
  inCells.resolution = 1;
  inCells.origin = {-0.5, -0.5};
  const Grid grid = gridOf(inCells);
  const VoronoiGraph voronoi =
      voronoiGraph(obstacleCells(grid, thinObstacles(grid, {}), hasUnknown(map)));
  KeepInsideOptions options;
  options.freeOnly = false;
  options.outsideAlphaPx2 = alpha;
  std::vector<Outline> outlines;
  const Regions regions =
      findRooms(voronoi, keepInside(voronoi, grid, options), std::sqrt(alpha), 0);
  Rooms rooms = traceRegions(voronoi, regions);
  rooms.resize(regions.roomCount);
  for (const Room& room : rooms) {
    Outline outline;
    outline.area = area(room.polygon);
    const auto add = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        outline.sides.insert(std::minmax(ring[i], ring[(i + 1) % ring.size()]));
    };
    add(room.polygon.outer);
    for (const Ring& hole : room.polygon.holes) add(hole);
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::vector<Outline> oracleRooms(const MapText& map, double alpha) {
  const Grid grid = gridOf(map);
  return Oracle(obstacleCells(grid, thinObstacles(grid, {}), hasUnknown(map)), alpha).rooms();
}

void expectSame(const MapText& map, double alpha) {
  auto ours = ourRooms(map, alpha), theirs = oracleRooms(map, alpha);
  ASSERT_EQ(ours.size(), theirs.size()) << map.name << " alpha " << alpha << "\n" << picture(map);
  const auto bySides = [](const Outline& a, const Outline& b) { return a.sides < b.sides; };
  std::sort(ours.begin(), ours.end(), bySides);
  std::sort(theirs.begin(), theirs.end(), bySides);
  for (std::size_t r = 0; r < ours.size(); ++r) {
    EXPECT_NEAR(ours[r].area, theirs[r].area, 1e-6) << map.name << " alpha " << alpha;
    EXPECT_EQ(ours[r].sides, theirs[r].sides) << map.name << " alpha " << alpha << "\n"
                                              << picture(map);
  }
}

// No squared radius of a circle through cell centres: what lies exactly between is not compared.
constexpr double kAlphas[] = {2.713, 6.317, 14.731, 41.239};

TEST(AlphaShapeOracle, hasTheSameRoomsOnTheDrawings) {
  for (const std::string& name : mapNames())
    for (const double alpha : kAlphas) expectSame(readMapText(name), alpha);
}

TEST(AlphaShapeOracle, hasTheSameRoomsOnRandomMaps) {
  for (std::uint32_t seed = 0; seed < 60; ++seed)
    for (const double alpha : kAlphas) expectSame(randomMap(seed, 48, 40, 0.1), alpha);
}

TEST(AlphaShapeOracle, hasTheSameRoomsInAnOfficeWithNoise) {
  const MapText office = noisyOffice(3, 500);
  EXPECT_GT(oracleRooms(office, 250.3).size(), 2u);
  expectSame(office, 250.3);
}

}  // namespace
}  // namespace roomgraph::test
