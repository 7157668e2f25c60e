#include "draw_layers.h"

#include <algorithm>
#include <array>

#include "View.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr double kCorridorPx = 2.0, kInsidePx = 1.3, kOutlinePx = 1.2;
constexpr double kDash[] = {4, 3};

/** Calls stroke now and then: cairo is slow with very long paths. */
class Strokes {
 public:
  Strokes(const Pen& pen, double widthPx) : pen_(pen), widthPx_(widthPx) {}
  ~Strokes() { pen_.stroke(widthPx_); }
  void add() {
    if (++count_ % 256 == 0) pen_.stroke(widthPx_);
  }

 private:
  const Pen& pen_;
  double widthPx_;
  int count_ = 0;
};

void strokeEdges(const Pen& pen, const TopologyGraph& graph, bool insideRooms, double widthPx) {
  Strokes strokes(pen, widthPx);
  for (const Edge& edge : graph.edges()) {
    if (bool(edge.room) != insideRooms) continue;
    pen.trace(edge.path.points);
    // One by one, or crossing lines of one stroke would each restart the dashes elsewhere.
    strokes.add();
  }
}

Colour darker(Colour c) {
  const auto dim = [](std::uint8_t v) { return std::uint8_t(v * 0.72); };
  return {dim(c.red), dim(c.green), dim(c.blue)};
}

void labelDisc(const Pen& pen, Point place, double radius, const std::string& label) {
  pen.traceDisc(place, radius);
  pen.paint(ink::paper, 0.95, ink::inside, 1, 1.4);
  const double sizePx = radius * (label.size() < 3 ? 1.15 : 0.86);
  pen.text(label, {place.x, place.y + 0.36 * sizePx}, sizePx, true, Pen::Align::centre);
}

const char* legendName(VertexKind kind, bool isMany) {
  constexpr const char* names[][2] = {{"junction", "junctions"},
                                      {"dead end", "dead ends"},
                                      {"border vertex", "border vertices"},
                                      {"room vertex", "room vertices"},
                                      {"ring vertex", "ring vertices"}};
  return names[std::size_t(kind)][isMany];
}

void strokeSample(const Pen& pen, Point place, Colour colour, double widthPx) {
  cairo_move_to(pen.cairo(), place.x - 9, place.y);
  cairo_line_to(pen.cairo(), place.x + 9, place.y);
  pen.ink(colour);
  pen.stroke(widthPx);
}

constexpr std::array<Colour, 6> kRoomColours{ink::sky,    ink::orange, ink::green,
                                             ink::purple, ink::yellow, ink::vermilion};
constexpr double kNeighbouring = 1.0;  // [m] between the boxes of two rooms

bool areNear(const Box& a, const Box& b) {
  return a.low.x - kNeighbouring < b.high.x && b.low.x - kNeighbouring < a.high.x &&
         a.low.y - kNeighbouring < b.high.y && b.low.y - kNeighbouring < a.high.y;
}

constexpr double kPassagePx = 2.4;
constexpr Colour kClutter{150, 60, 118};

/** Fills and strokes the rings of the current path. */
void finishRings(const Pen& pen) {
  cairo_set_fill_rule(pen.cairo(), CAIRO_FILL_RULE_WINDING);
  pen.paint(kClutter, 0.12, kClutter, 0.5, 0.5);
}

}  // namespace

std::vector<Colour> roomColours(const std::vector<const Polygon*>& rooms) {
  std::vector<Box> boxes;
  std::vector<std::size_t> choice;
  std::array<int, kRoomColours.size()> used{};
  for (const Polygon* room : rooms) {
    boxes.push_back(room->outer.empty() ? Box{} : boundingBox(room->outer));
    std::array<int, kRoomColours.size()> usedNear{};
    for (std::size_t r = 0; r < choice.size(); ++r)
      if (areNear(boxes.back(), boxes[r])) ++usedNear[choice[r]];
    std::size_t best = 0;
    for (std::size_t c = 1; c < kRoomColours.size(); ++c)
      if (std::make_pair(usedNear[c], used[c]) < std::make_pair(usedNear[best], used[best]))
        best = c;
    ++used[best];
    choice.push_back(best);
  }
  return mapped(choice, [](std::size_t c) { return kRoomColours[c]; });
}

void drawRooms(const Pen& pen, const std::vector<const Polygon*>& rooms) {
  const std::vector<Colour> colours = roomColours(rooms);
  cairo_set_line_join(pen.cairo(), CAIRO_LINE_JOIN_ROUND);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    pen.trace(*rooms[r]);
    cairo_set_fill_rule(pen.cairo(), CAIRO_FILL_RULE_EVEN_ODD);
    pen.paint(colours[r], 0.34, darker(colours[r]), 0.85, kOutlinePx);
  }
}

void drawPaths(const Pen& pen, const TopologyGraph& graph) {
  cairo_set_line_join(pen.cairo(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(pen.cairo(), kDash, 2, 0);
  pen.ink(ink::inside, 0.9);
  strokeEdges(pen, graph, true, kInsidePx);
  cairo_set_dash(pen.cairo(), nullptr, 0, 0);
  pen.ink(ink::blue);
  strokeEdges(pen, graph, false, kCorridorPx);
}

void drawVertices(const Pen& pen, const TopologyGraph& graph) {
  for (const Vertex& vertex : graph.vertices())
    if (vertex.kind != VertexKind::room) pen.mark(vertex.kind, pen.view().px(vertex.place));
}

void drawRoomLabels(const Pen& pen, const std::vector<GraphRoom>& rooms) {
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const double room = rooms[r].shape.inscribedRadius * pen.view().pxPerMetre();
    labelDisc(pen, pen.view().px(rooms[r].center), std::clamp(0.45 * room, 8.0, 13.0),
              std::to_string(r));
  }
}

void drawObstacles(const Pen& pen, const ObstacleCells& obstacles) {
  const double half = std::max(0.6, 0.5 * obstacles.frame.resolution * pen.view().pxPerMetre());
  pen.ink(ink::vermilion);
  int count = 0;
  for (const Cell cell : obstacles.cells) {
    pen.traceBox(pen.view().px(obstacles.frame.center(cell)), {half, half});
    if (++count % 256 == 0) cairo_fill(pen.cairo());
  }
  cairo_fill(pen.cairo());
}

void drawVoronoi(const Pen& pen, const VoronoiGraph& graph,
                 const std::function<bool(std::size_t)>& isShown, Colour colour) {
  pen.ink(colour);
  Strokes strokes(pen, 0.9);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const VoronoiEdge& edge = graph.edges[e];
    if (edge.isInfinite() || !isShown(e)) continue;
    pen.trace(Polyline{graph.vertices[edge.source].place, graph.vertices[edge.target].place});
    strokes.add();
  }
}

std::vector<LegendItem> graphLegend(const TopologyGraph& graph) {
  std::vector<LegendItem> items;
  for (const VertexKind kind :
       {VertexKind::border, VertexKind::junction, VertexKind::deadEnd, VertexKind::ring}) {
    const auto count = countIf(graph.vertices(), [&](const Vertex& v) { return v.kind == kind; });
    if (count == 0) continue;
    items.push_back(
        {groupedCount(std::size_t(count), legendName(kind, false), legendName(kind, true)),
         [kind](const Pen& pen, Point place) { pen.mark(kind, place); }});
  }
  const auto inside = countIf(graph.edges(), [](const Edge& e) { return bool(e.room); });
  if (inside < graph.edges().size())
    items.push_back(lineLegend(
        groupedCount(graph.edges().size() - inside, "path outside rooms", "paths outside rooms"),
        ink::blue, kCorridorPx));
  if (inside > 0)
    items.push_back({groupedCount(inside, "way inside a room", "ways inside rooms"),
                     [](const Pen& pen, Point place) {
                       cairo_set_dash(pen.cairo(), kDash, 2, 0);
                       strokeSample(pen, place, ink::inside, kInsidePx);
                       cairo_set_dash(pen.cairo(), nullptr, 0, 0);
                     }});
  return items;
}

LegendItem roomLegend(std::size_t count) {
  return {groupedCount(count, "room", "rooms"), [](const Pen& pen, Point place) {
            pen.traceBox(place, {9, 6});
            pen.paint(ink::sky, 0.34, darker(ink::sky), 0.85, kOutlinePx);
            pen.mark(VertexKind::room, place);
          }};
}

std::vector<LegendItem> stateLegend(const Grid& grid) {
  std::vector<LegendItem> items;
  const auto add = [&](State state, const char* label) {
    if (grid.has(state)) items.push_back(squareLegend(label, stateColour(state)));
  };
  add(State::free, "free");
  add(State::occupied, "occupied");
  add(State::unknown, "unknown");
  return items;
}

LegendItem lineLegend(const std::string& label, Colour colour, double widthPx) {
  return {label, [=](const Pen& pen, Point place) { strokeSample(pen, place, colour, widthPx); }};
}

LegendItem squareLegend(const std::string& label, Colour colour) {
  return {label, [=](const Pen& pen, Point place) {
            pen.traceBox(place, {5.5, 5.5});
            pen.paint(colour, 1, ink::quiet, 0.6, 1);
          }};
}

std::string groupedCount(std::size_t count, const std::string& one, const std::string& many) {
  std::string digits = std::to_string(count);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, "\u2009");
  return digits + " " + (count == 1 ? one : many);
}

void drawPassages(const Pen& pen, const std::vector<Passage>& passages) {
  pen.ink(ink::orange);
  for (const Passage& passage : passages) {
    pen.trace(Polyline{passage.from, passage.to});
    pen.stroke(kPassagePx);
  }
}

void drawClutter(const Pen& pen, const std::vector<Clutter>& clutter) {
  // Together, so that a heap does not get darker and darker; but cairo is slow with long paths.
  int count = 0;
  for (const Clutter& piece : clutter) {
    const double radius = 0.5 * piece.size * pen.view().pxPerMetre();
    pen.traceDisc(pen.view().px(piece.center), std::max(1.2, radius));
    if (++count % 64 == 0) finishRings(pen);
  }
  finishRings(pen);
}

std::vector<LegendItem> areaLegend(const Stages& stages) {
  std::vector<LegendItem> items;
  if (const std::size_t count = stages.areas.passages.size())
    items.push_back(
        lineLegend(groupedCount(count, "passage", "passages"), ink::orange, kPassagePx));
  if (!stages.cleared.clutter.empty())
    items.push_back({"clutter", [](const Pen& pen, Point place) {
                       pen.traceDisc(place, 5);
                       finishRings(pen);
                     }});
  return items;
}

}  // namespace roomgraph
