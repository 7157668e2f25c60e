#include "roomgraph/mrpt_plugin/draw_graph.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/geometry/thinned_line.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/shapes.h"
#include "triangulate.h"

namespace roomgraph {
namespace {

// How the parts lie above each other, in layers.
enum Layer {
  kFloorLayer = 1,
  kOutlineLayer,
  kRoomWayLayer,
  kCorridorLayer,
  kRimLayer,
  kDiscLayer,
  kNumberLayer
};

/** Draws relative to a place in the middle: MRPT draws in single precision. */
struct Sheet {
  Point anchor;
  double layerHeight = 0;
  double discRadius = 0;  // of a vertex that is no room

  mrpt::math::TPoint3Df at(Point p, Layer layer) const {
    const Point q = p - anchor;
    return {float(q.x), float(q.y), float(int(layer) * layerHeight)};
  }
};

void addTriangle(viz::CSetOfTriangles& triangles, const std::array<mrpt::math::TPoint3Df, 3>& at,
                 Colour colour) {
  viz::TTriangle triangle(at[0], at[1], at[2]);
  triangle.setColor(mrptColour(colour));
  triangles.insertTriangle(triangle);
}

void addDisc(viz::CSetOfTriangles& triangles, const Sheet& sheet, Point center, double radius,
             Layer layer, Colour colour) {
  constexpr int corners = 24;
  const auto corner = [&](int i) {
    const double angle = 2 * M_PI * (i % corners) / corners;
    return sheet.at(center + radius * Point{std::cos(angle), std::sin(angle)}, layer);
  };
  for (int i = 0; i < corners; ++i)
    addTriangle(triangles, {sheet.at(center, layer), corner(i), corner(i + 1)}, colour);
}

viz::CSetOfTriangles::Ptr makeTriangles(const std::string& name) {
  auto triangles = viz::CSetOfTriangles::Create();
  triangles->setName(name);
  triangles->enableLight(false);  // the colours are those of the legend
  return triangles;
}

/** Where the left edge of a ribbon runs by its i-th point; the right edge mirrors it. */
Point sideways(const Polyline& line, std::size_t i, bool isClosed) {
  const std::size_t n = line.size();
  const auto normal = [&](std::size_t from) {
    const Point along = line[(from + 1) % n] - line[from];
    const double size = norm(along);
    return size > 0 ? (1 / size) * toLeft(along) : Point{};
  };
  const bool hasBefore = isClosed || i > 0, hasAfter = isClosed || i + 1 < n;
  const Point before = hasBefore ? normal((i + n - 1) % n) : normal(i);
  const Point sum = before + (hasAfter ? normal(i) : before);
  // A mitre keeps the width; at sharp turns it would be a spike.
  const double scale = 2 / std::max(1.0, squaredNorm(sum));
  return scale * sum;
}

/** The points that an eye can tell apart in a ribbon of this width; of a closed line, the first is
 *  not repeated. */
Polyline drawnPoints(Polyline line, bool isClosed, double width) {
  constexpr double share = 0.05;
  if (isClosed) line.push_back(line.front());
  line = thinnedLine(line, share * width);
  if (isClosed) line.pop_back();
  return line;
}

/** A line as a flat ribbon: OpenGL's own lines are one pixel wide on most machines. */
void addRibbon(viz::CSetOfTriangles& triangles, const Sheet& sheet, const Polyline& all,
               bool isClosed, double width, Layer layer, Colour colour) {
  if (all.empty()) return;
  const Polyline line = drawnPoints(all, isClosed, width);
  const std::size_t n = line.size();
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Point a = (width / 2) * sideways(line, i, isClosed);
    const Point b = (width / 2) * sideways(line, next, isClosed);
    const auto left = sheet.at(line[i] + a, layer), right = sheet.at(line[i] - a, layer);
    const auto nextLeft = sheet.at(line[next] + b, layer);
    const auto nextRight = sheet.at(line[next] - b, layer);
    addTriangle(triangles, {right, nextRight, left}, colour);
    addTriangle(triangles, {left, nextRight, nextLeft}, colour);
  }
}

viz::CSetOfTriangles::Ptr drawFloors(const RoomGraph& graph, const Sheet& sheet) {
  auto floors = makeTriangles("rooms");
  for (std::size_t i = 0; i < graph.rooms.size(); ++i)
    for (const Triangle& t : triangulate(graph.rooms[i].shape.polygon))
      addTriangle(
          *floors,
          {sheet.at(t[0], kFloorLayer), sheet.at(t[1], kFloorLayer), sheet.at(t[2], kFloorLayer)},
          roomColour(i));
  return floors;
}

viz::CSetOfTriangles::Ptr drawOutlines(const RoomGraph& graph, const Sheet& sheet) {
  auto outlines = makeTriangles("room outlines");
  for (const GraphRoom& room : graph.rooms)
    forEachRing(room.shape.polygon, [&](const Ring& ring) {
      addRibbon(*outlines, sheet, ring, true, 0.25 * sheet.discRadius, kOutlineLayer,
                kRoomOutlineColour);
    });
  return outlines;
}

viz::CSetOfTriangles::Ptr drawWays(const RoomGraph& graph, const Sheet& sheet, bool inRooms) {
  auto ways = makeTriangles(inRooms ? "ways in rooms" : "corridors");
  const double width = (inRooms ? 0.45 : 0.7) * sheet.discRadius;
  for (const Edge& edge : graph.graph.edges())
    if (bool(edge.room) == inRooms)
      addRibbon(*ways, sheet, edge.path.points, false, width,
                inRooms ? kRoomWayLayer : kCorridorLayer,
                inRooms ? kRoomWayColour : kCorridorColour);
  return ways;
}

/** Room vertices are large enough for a number, yet no larger than their room. */
double discRadius(const RoomGraph& graph, const Vertex& vertex, const Sheet& sheet) {
  if (vertex.kind != VertexKind::room || !vertex.room) return sheet.discRadius;
  const double fits = graph.rooms[vertex.room.index()].shape.inscribedRadius / 2;
  return std::clamp(fits, sheet.discRadius, 2.4 * sheet.discRadius);
}

viz::CSetOfTriangles::Ptr drawVertices(const RoomGraph& graph, const Sheet& sheet) {
  auto discs = makeTriangles("vertices");
  for (const Vertex& vertex : graph.graph.vertices()) {
    const double radius = discRadius(graph, vertex, sheet);
    addDisc(*discs, sheet, vertex.place, radius + 0.22 * sheet.discRadius, kRimLayer, kRimColour);
    addDisc(*discs, sheet, vertex.place, radius, kDiscLayer, vertexColour(vertex.kind));
  }
  return discs;
}

viz::CText3D::Ptr drawNumber(std::size_t number, Point point, double discRadius,
                             const Sheet& sheet) {
  auto text = viz::CText3D::Create(std::to_string(number), "sans", 1.0F, viz::FILL);
  text->setColor_u8(mrptColour(kRimColour));
  // The text's box tells how large it is at scale 1, and where its middle lies.
  const auto box = text->getBoundingBox();
  const double width = box.max.x - box.min.x, height = box.max.y - box.min.y;
  const double scale = 1.5 * discRadius / std::max(1e-6, std::hypot(width, height));
  const Point middle{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2};
  const auto place = sheet.at(point - scale * middle, kNumberLayer);
  text->setScale(float(scale));
  text->setLocation(place.x, place.y, place.z);
  return text;
}

viz::CSetOfObjects::Ptr drawNumbers(const RoomGraph& graph, const Sheet& sheet) {
  auto numbers = setNamed("room numbers");
  for (std::size_t i = 0; i < graph.rooms.size(); ++i) {
    if (!graph.rooms[i].vertex) continue;
    const Vertex& vertex = graph.graph.vertex(graph.rooms[i].vertex);
    numbers->insert(drawNumber(i, vertex.place, discRadius(graph, vertex, sheet), sheet));
  }
  return numbers;
}

Sheet makeSheet(const MappedGraph& graph) {
  const Box box = drawnBox(graph);
  const double size = distance(box.low, box.high);
  Sheet sheet;
  sheet.anchor = midpoint(box.low, box.high);
  sheet.layerHeight = 0.0015 * size;
  sheet.discRadius = std::clamp(0.0075 * size, 0.02, 0.6);
  return sheet;
}

std::uint8_t greyOf(State state) {
  if (state == State::unknown) return kUnknownGrey;
  return state == State::free ? kFreeGrey : kOccupiedGrey;
}

/** The map as a textured plane at z = 0, shifted by -`anchor`. A cell of the picture shows the
 *  darkest of the map cells that it stands for, so that thin walls stay. O(cells). */
viz::CTexturedPlane::Ptr drawMap(const Grid& map, Point anchor) {
  const GridFrame& frame = map.frame;
  const int step = (std::max(frame.width, frame.height) + kMostTexels - 1) / kMostTexels;
  const int width = (frame.width + step - 1) / step, height = (frame.height + step - 1) / step;
  mrpt::img::CImage image(unsigned(width), unsigned(height), mrpt::img::CH_GRAY);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at<std::uint8_t>(unsigned(x), unsigned(y)) = 255;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      auto& texel = image.at<std::uint8_t>(unsigned(x / step), unsigned(y / step));
      texel = std::min(texel, greyOf(map.at({x, y})));
    }
  const Point low = frame.origin - anchor;
  const double side = frame.resolution * step;
  auto plane = viz::CTexturedPlane::Create(float(low.x), float(low.x + width * side), float(low.y),
                                           float(low.y + height * side));
  plane->setName("map");
  plane->assignImage(std::move(image));
  return plane;
}

}  // namespace

void lookFromAbove(MrptScene& scene, const Box& box, double turn) {
  const auto view = scene.getViewport();
  view->setCustomBackgroundColor({kBackgroundColour.red / 255.F, kBackgroundColour.green / 255.F,
                                  kBackgroundColour.blue / 255.F});
  scene.enableFollowCamera(true);  // else SceneViewer3D looks from where it likes
  // Even light, so that the colours are those of the legend: the files know no unlit triangles.
  makeEven(view->lightParameters());
  const Point middle = Transform2D{0, 0, -turn}(midpoint(box.low, box.high));
  const Point size = box.high - box.low;
  auto& camera = view->getCamera();
  camera.setPointingAt(float(middle.x), float(middle.y), 0);
  camera.setAzimuthDegrees(float(-90 - turn * 180 / M_PI));  // what is turned has its y up
  camera.setElevationDegrees(70);
  camera.setProjectiveFOVdeg(30);
  // The whole box in a window that is wider than high.
  const double half = std::max(size.y, 0.75 * size.x) / 2;
  camera.setZoomDistance(float(1.1 * half / std::tan(M_PI / 12)));
}

Box drawnBox(const MappedGraph& graph) {
  Box box;
  for (const Vertex& vertex : graph.file.graph.graph.vertices()) box.include(vertex.place);
  for (const GraphRoom& room : graph.file.graph.rooms)
    for (const Point p : room.shape.polygon.outer) box.include(p);
  for (const Edge& edge : graph.file.graph.graph.edges())
    for (const Point p : edge.path.points) box.include(p);
  if (graph.map && !graph.map->cells.empty()) {
    const GridFrame& frame = graph.map->frame;
    box.include(frame.origin);
    box.include(frame.origin + frame.resolution * Point{double(frame.width), double(frame.height)});
  }
  return box.isEmpty() ? Box{{-0.5, -0.5}, {0.5, 0.5}} : box;
}

viz::CSetOfObjects::Ptr drawGraph(const MappedGraph& graph, const viz::CSetOfObjects::Ptr& before) {
  const Sheet sheet = makeSheet(graph);
  const RoomGraph& rooms = graph.file.graph;
  auto all = setNamed("room graph");
  all->setLocation(sheet.anchor.x, sheet.anchor.y, 0);
  if (graph.map && !graph.map->cells.empty()) {
    const bool isSame = before && before->getPose() == all->getPose();
    const auto map = isSame ? before->getByName("map") : nullptr;
    all->insert(map ? map : drawMap(*graph.map, sheet.anchor));
  }
  for (const auto& part :
       {drawFloors(rooms, sheet), drawOutlines(rooms, sheet), drawWays(rooms, sheet, true),
        drawWays(rooms, sheet, false), drawVertices(rooms, sheet)})
    if (part->getTrianglesCount() > 0) all->insert(part);
  if (!rooms.rooms.empty()) all->insert(drawNumbers(rooms, sheet));
  return all;
}

}  // namespace roomgraph
