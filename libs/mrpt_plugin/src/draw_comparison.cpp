#include "roomgraph/mrpt_plugin/draw_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/shapes.h"

namespace roomgraph {
namespace {

constexpr double kLayerHeight = 0.1;  // between runs [m]
constexpr double kBreakRadius = 0.6;  // [m]
// Shows on light, on RawLogViewer's grey, on walls.
constexpr mrpt::img::TColor kWordColour{15, 15, 20};

viz::CPointCloud::Ptr cloudOf(const std::vector<Point>& walls, std::size_t run) {
  const Box box = boundingBox(walls);
  const Point middle = midpoint(box.low, box.high);  // MRPT draws in single precision
  const auto places = mapped(walls, [&](Point wall) { return wall - middle; });
  auto cloud = pointsAt(places, 0, mrptColour(runColour(run)), 3);
  cloud->setName("walls");
  cloud->setLocation(middle.x, middle.y, 0);
  return cloud;
}

viz::CSetOfLines::Ptr outlinesOf(const std::vector<SiteRoom>& rooms, double height) {
  std::vector<Segment> edges;
  for (const SiteRoom& room : rooms)
    forEachEdge(room.polygon, [&](Point a, Point b) { edges.emplace_back(a, b); });
  auto lines = linesAt(edges, height, mrptColour(kRoomOutlineColour), 2);
  lines->setName("rooms");
  return lines;
}

/** Where the horizontal line at `y` crosses the polygon, ascending. */
std::vector<double> crossings(const Polygon& polygon, double y) {
  std::vector<double> xs;
  forEachEdge(polygon, [&](Point a, Point b) {
    if ((a.y > y) != (b.y > y)) xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  });
  std::sort(xs.begin(), xs.end());
  return xs;
}

/** A place with much room on all sides: of the middles of some horizontal lines in the room, moved
 *  to the middle of the vertical line through them, the one whose shorter line is longest. */
Point labelPlace(const SiteRoom& room) {
  if (room.polygon.outer.size() < 3) return room.center;
  const Box box = boundingBox(room.polygon.outer);
  const Polygon across = movedBy(room.polygon, [](Point p) { return Point{p.y, p.x}; });
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

/** Words that lean back: to be read from above, and from the side that RawLogViewer looks from. */
class Writer {
 public:
  /** `letter` is the height of the letters [m]; lines run level where all is turned by `turn`. */
  Writer(double letter, double turn) : letter_(letter), level_(Transform2D{0, 0, -turn}) {}

  /** They start at `place`, or have it in their middle; or some lines above or below it, so that
   *  they lie over no words written before. */
  viz::CText3D::Ptr written(const std::string& words, const mrpt::img::TColor& colour, Point place,
                            double height, bool isCentred = false) {
    auto text = viz::CText3D::Create(words, "sans", float(letter_), viz::FILL);
    text->setColor_u8(colour);
    const auto box = text->getBoundingBox();
    const Point low{double(box.min.x), double(box.min.y)},
        high{double(box.max.x), double(box.max.y)};
    Point start = level_.inverse()(place);
    if (isCentred) start = start - midpoint(low, high);
    start = clearOfOthers({start + low, start + high}) - low;
    place = level_(start);
    text->setPose(mrpt::poses::CPose3D(place.x, place.y, height, level_.phi, 0, M_PI / 5));
    return text;
  }

  double letter() const { return letter_; }
  /** Frame of the site <- what is to be read. */
  const Transform2D& level() const { return level_; }

 private:
  /** The lower left corner of a box of words, moved by up to ten lines so that it lies over no
   *  others; they keep theirs. */
  Point clearOfOthers(const Box& words) {
    for (int i = 0; i < 20; ++i) {
      const int line = (i + 1) / 2 * (i % 2 == 0 ? -1 : 1);
      const Point up{0, line * kLegendLine * letter_};
      const Box moved{words.low + up, words.high + up};
      if (anyOf(taken_, [&](const Box& other) {
            return moved.low.x < other.high.x && other.low.x < moved.high.x &&
                   moved.low.y < other.high.y && other.low.y < moved.high.y;
          }))
        continue;
      taken_.push_back(moved);
      return moved.low;
    }
    return words.low;
  }

  double letter_;
  Transform2D level_;
  std::vector<Box> taken_;  ///< by words, in the frame of what is to be read
};

viz::CSetOfObjects::Ptr namesOf(const std::vector<SiteRoom>& rooms, Writer& writer, double height) {
  auto names = setNamed("room names");
  for (const SiteRoom& room : rooms)
    names->insert(writer.written(room.name.empty() ? room.id : room.name, kWordColour,
                                 namePlace(room), height, true));
  return names;
}

/** The names of the first runs in their colours, below the maps, whose lower left corner is
 *  `corner`, as it is to be read. */
viz::CSetOfObjects::Ptr legendOf(const std::vector<ComparedRun>& runs, Writer& writer, Point corner,
                                 double height) {
  auto legend = setNamed("legend");
  for (std::size_t i = 0; i < std::min(runs.size(), kMostNamed); ++i) {
    corner.y -= kLegendLine * writer.letter();
    legend->insert(
        writer.written(runs[i].name, mrptColour(runColour(i)), writer.level()(corner), height));
  }
  return legend;
}

viz::CSetOfObjects::Ptr breaksOf(const Comparison& comparison, Writer& writer, double height) {
  std::map<std::string, std::size_t> places;  // by the name of the run; the first for any other
  for (const ComparedRun& run : comparison.runs) places.emplace(run.name, places.size());
  auto rings = setNamed("breaks");
  for (const MapBreak& tear : comparison.breaks) {
    rings->insert(diskAt(tear.place, height, mrptColour(runColour(places[tear.run])), kBreakRadius,
                         0.7 * kBreakRadius));
    if (tear.keyFrame)
      rings->insert(writer.written(
          std::to_string(*tear.keyFrame), kWordColour,
          tear.place + writer.level()(Point{-kBreakRadius, 1.2 * kBreakRadius}), height));
  }
  return rings;
}

std::vector<Point> wallCells(const WallMap& map) {
  std::vector<Point> walls;
  const auto isWall = [&](Cell c) { return map.states[map.frame.index(c)] == State::occupied; };
  for (const Cell c : map.frame.cellsWhere(isWall)) walls.push_back(map.frame.center(c));
  return walls;
}

/** Of a run; null where its walls are not known. */
const std::vector<Point>* wallsOf(const RunWalls& walls, const std::string& run) {
  const auto found = walls.find(run);
  return found == walls.end() || found->second.empty() ? nullptr : &found->second;
}

}  // namespace

std::string runLayer(const std::string& run) { return "run " + run; }

RunWalls runWalls(const std::vector<Run>& runs) {
  RunWalls walls;
  for (const Run& run : runs) walls.emplace(run.name, wallCells(run.map));
  return walls;
}

Box drawnBox(const Comparison& comparison, const RunWalls& walls, double turn) {
  Box box;
  for (const ComparedRun& run : comparison.runs) {
    const auto* known = wallsOf(walls, run.name);
    if (!known) continue;
    const Motion2D move(Transform2D{0, 0, turn} * run.pose);
    for (const Point wall : *known) box.include(move(wall));
  }
  return box.isEmpty() ? Box{{-0.5, -0.5}, {0.5, 0.5}} : box;
}

double letterHeight(const Box& box) {
  return std::clamp(0.018 * std::max(box.size().x, box.size().y), 0.4, 1.5);
}

viz::CSetOfObjects::Ptr drawComparison(const Comparison& comparison, const RunWalls& walls,
                                       double turn) {
  auto all = setNamed("comparison");
  const Box box = drawnBox(comparison, walls, turn);
  Writer writer(letterHeight(box), turn);
  const std::size_t count = comparison.runs.size();
  for (std::size_t i = count; i-- > 0;) {
    const ComparedRun& run = comparison.runs[i];
    const auto* known = wallsOf(walls, run.name);
    if (!known) continue;
    auto layer = setNamed(runLayer(run.name));
    layer->setPose(mrpt::poses::CPose3D(run.pose.x, run.pose.y,
                                        double(count - 1 - i) * kLayerHeight, run.pose.phi, 0, 0));
    layer->insert(cloudOf(*known, i));
    all->insert(layer);
  }
  const double top = double(count) * kLayerHeight;
  if (!comparison.rooms.empty()) {
    all->insert(outlinesOf(comparison.rooms, top));
    all->insert(namesOf(comparison.rooms, writer, top + kLayerHeight));
  }
  if (!comparison.breaks.empty()) all->insert(breaksOf(comparison, writer, top + 2 * kLayerHeight));
  if (count > 0) all->insert(legendOf(comparison.runs, writer, box.low, top));
  return all;
}

}  // namespace roomgraph
