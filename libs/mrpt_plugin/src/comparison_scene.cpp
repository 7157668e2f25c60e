#include "roomgraph/mrpt_plugin/comparison_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "look_from_above.h"
#include "object_bytes.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/mrpt_plugin/colors.h"

namespace roomgraph {
namespace {

constexpr double kLayerHeight = 0.1;    // between runs [m]
constexpr double kBreakRadius = 0.6;    // [m]
constexpr double kLetterHeight = 0.5;   // [m]
constexpr std::size_t kMostNamed = 14;  // as many as have colours of their own

mrpt::img::TColor colourOf(std::size_t run) {
  const Colour c = runColour(run);
  return {c.red, c.green, c.blue};
}

viz::CPointCloud::Ptr wallsOf(const MapForAlignment& map, std::size_t run) {
  auto cloud = viz::CPointCloud::Create();
  cloud->setName("walls");
  cloud->setColor_u8(colourOf(run));
  cloud->setPointSize(3);
  const Point middle = map.middle();  // MRPT draws in single precision
  cloud->setLocation(middle.x, middle.y, 0);
  for (int y = 0; y < map.frame.height; ++y)
    for (int x = 0; x < map.frame.width; ++x)
      if (map.states[map.frame.index({x, y})] == State::occupied) {
        const Point p = map.frame.center({x, y}) - middle;
        cloud->insertPoint(float(p.x), float(p.y), 0);
      }
  return cloud;
}

viz::CSetOfLines::Ptr outlinesOf(const std::vector<SiteRoom>& rooms, double height) {
  auto lines = viz::CSetOfLines::Create();
  lines->setName("rooms");
  lines->setColor_u8({kRoomOutlineColor.r, kRoomOutlineColor.g, kRoomOutlineColor.b});
  lines->setLineWidth(2);
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      lines->appendLine(a.x, a.y, height, b.x, b.y, height);
    }
  };
  for (const SiteRoom& room : rooms) {
    add(room.polygon.outer);
    for (const Ring& hole : room.polygon.holes) add(hole);
  }
  return lines;
}

/** Where the horizontal line at `y` crosses the polygon, ascending. */
std::vector<double> crossings(const Polygon& polygon, double y) {
  std::vector<double> xs;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > y) != (b.y > y)) xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  std::sort(xs.begin(), xs.end());
  return xs;
}

/** The same polygon with x and y exchanged. */
Polygon exchanged(Polygon polygon) {
  const auto exchange = [](Ring& ring) {
    for (Point& p : ring) std::swap(p.x, p.y);
  };
  exchange(polygon.outer);
  for (Ring& hole : polygon.holes) exchange(hole);
  return polygon;
}

/** A place with much room on all sides: of the middles of some horizontal lines in the room, moved
 *  to the middle of the vertical line through them, the one whose shorter line is longest. */
Point labelPlace(const SiteRoom& room) {
  if (room.polygon.outer.size() < 3) return room.center;
  const Box box = boundingBox(room.polygon.outer);
  const Polygon across = exchanged(room.polygon);
  Point best = room.center;
  double most = 0;
  constexpr int rows = 31;
  for (int row = 0; row < rows; ++row) {
    const double y = box.low.y + (box.high.y - box.low.y) * (row + 0.5) / rows;
    const std::vector<double> xs = crossings(room.polygon, y);
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      const double x = (xs[i] + xs[i + 1]) / 2;
      const std::vector<double> ys = crossings(across, x);
      for (std::size_t k = 0; k + 1 < ys.size(); k += 2) {
        const double shorter = std::min(xs[i + 1] - xs[i], ys[k + 1] - ys[k]);
        if (y < ys[k] || y > ys[k + 1] || shorter < most + 0.01) continue;
        most = shorter, best = {x, (ys[k] + ys[k + 1]) / 2};
      }
    }
  }
  return best;
}

/** Where the name of a room is put: in its middle, if that lies in it. */
Point namePlace(const SiteRoom& room) {
  return sideOf(room.polygon, room.center) == Side::inside ? room.center : labelPlace(room);
}

viz::CSetOfObjects::Ptr namesOf(const std::vector<SiteRoom>& rooms, double height) {
  auto names = viz::CSetOfObjects::Create();
  names->setName("room names");
  for (const SiteRoom& room : rooms) {
    auto text = viz::CText3D::Create(room.name.empty() ? room.id : room.name, "sans", kLetterHeight,
                                     viz::FILL);
    text->setColor_u8({kRoomOutlineColor.r, kRoomOutlineColor.g, kRoomOutlineColor.b});
    const auto box = text->getBoundingBox();
    const Point place = namePlace(room);
    text->setLocation(place.x - double(box.min.x + box.max.x) / 2,
                      place.y - double(box.min.y + box.max.y) / 2, height);
    names->insert(text);
  }
  return names;
}

viz::CText3D::Ptr written(const std::string& words, mrpt::img::TColor colour, Point place,
                          double height) {
  auto text = viz::CText3D::Create(words, "sans", kLetterHeight, viz::FILL);
  text->setColor_u8(colour);
  text->setLocation(place.x, place.y, height);
  return text;
}

/** The names of the first runs in their colours, below the maps, which lie in `box`; makes it
 *  larger. */
viz::CSetOfObjects::Ptr legendOf(const std::vector<ComparedRun>& runs, Box& box, double height) {
  auto legend = viz::CSetOfObjects::Create();
  legend->setName("legend");
  constexpr double line = 1.6 * kLetterHeight;
  for (std::size_t i = 0; i < runs.size() && i < kMostNamed; ++i) {
    box.low.y -= line;
    legend->insert(written(runs[i].name, colourOf(i), box.low, height));
  }
  return legend;
}

viz::CSetOfObjects::Ptr breaksOf(const Comparison& comparison, double height) {
  std::map<std::string, std::size_t> places;
  for (const ComparedRun& run : comparison.runs) places.emplace(run.name, places.size());
  auto rings = viz::CSetOfObjects::Create();
  rings->setName("breaks");
  for (const MapBreak& bend : comparison.breaks) {
    auto ring = viz::CDisk::Create();
    ring->setName(bend.run);
    ring->setDiskRadius(float(kBreakRadius), float(0.7 * kBreakRadius));
    const auto found = places.find(bend.run);
    ring->setColor_u8(colourOf(found == places.end() ? 0 : found->second));
    ring->setLocation(bend.place.x, bend.place.y, height);
    rings->insert(ring);
    std::string words = bend.run;
    if (bend.keyFrame) words += ", key frame " + std::to_string(*bend.keyFrame);
    rings->insert(written(words, ring->getColor_u8(),
                          bend.place + Point{-kBreakRadius, 1.2 * kBreakRadius}, height));
  }
  return rings;
}

/** Round the walls of all maps; a square metre for none. */
Box boxOf(const std::vector<std::pair<const MapForAlignment*, Transform2D>>& placed) {
  std::vector<Point> places;
  for (const auto& [map, pose] : placed) {
    if (!map) continue;
    const Motion2D move(pose);
    for (const WallPoint& wall : map->walls) places.push_back(move(wall.place));
  }
  return places.empty() ? Box{{-0.5, -0.5}, {0.5, 0.5}} : boundingBox(places);
}

}  // namespace

MrptScene comparisonScene(const Comparison& comparison, const std::vector<Run>& runs) {
  std::map<std::string, const MapForAlignment*> maps;
  for (const Run& run : runs) maps.emplace(run.name, &run.map);
  std::vector<std::pair<const MapForAlignment*, Transform2D>> placed;
  for (const ComparedRun& run : comparison.runs) {
    const auto found = maps.find(run.name);
    placed.emplace_back(found == maps.end() ? nullptr : found->second, run.pose);
  }
  MrptScene scene;
  for (std::size_t i = placed.size(); i-- > 0;) {
    const auto& [map, pose] = placed[i];
    if (!map) continue;
    auto layer = viz::CSetOfObjects::Create();
    layer->setName(comparison.runs[i].name);
    layer->setPose(mrpt::poses::CPose3D(
        pose.x, pose.y, double(placed.size() - 1 - i) * kLayerHeight, pose.phi, 0, 0));
    layer->insert(wallsOf(*map, i));
    scene.insert(layer);
  }
  const double top = double(placed.size()) * kLayerHeight;
  if (!comparison.rooms.empty()) {
    scene.insert(outlinesOf(comparison.rooms, top));
    scene.insert(namesOf(comparison.rooms, top + kLayerHeight));
  }
  if (!comparison.breaks.empty()) scene.insert(breaksOf(comparison, top + 2 * kLayerHeight));
  Box box = boxOf(placed);
  if (!comparison.runs.empty()) scene.insert(legendOf(comparison.runs, box, top));
  lookFromAbove(scene, box);
  return scene;
}

std::string comparisonSceneBytes(const Comparison& comparison, const std::vector<Run>& runs) {
  return gzippedObject(comparisonScene(comparison, runs));
}

}  // namespace roomgraph
