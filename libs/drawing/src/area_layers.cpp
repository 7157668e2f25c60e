#include "area_layers.h"

#include <algorithm>

#include "draw_layers.h"

namespace roomgraph {
namespace {

constexpr double kPassagePx = 2.4, kRingPx = 0.5;
constexpr double kLeastPx = 1.2;
constexpr Colour kClutter{150, 60, 118};

/** Adds to cairo's current path. */
void addRing(const Pen& pen, Point at, double radius) {
  cairo_new_sub_path(pen.cairo());
  cairo_arc(pen.cairo(), at.x, at.y, radius, 0, 6.283185307179586);
}

/** Fills and strokes the rings of the current path. */
void finishRings(const Pen& pen) {
  cairo_set_fill_rule(pen.cairo(), CAIRO_FILL_RULE_WINDING);
  pen.ink(kClutter, 0.12);
  cairo_fill_preserve(pen.cairo());
  pen.ink(kClutter, 0.5);
  pen.stroke(kRingPx);
}

}  // namespace

void drawAreas(const Pen& pen, const std::vector<Area>& areas) {
  std::vector<const Polygon*> polygons;
  for (const Area& area : areas) polygons.push_back(&area.polygon);
  drawRooms(pen, polygons);
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
    addRing(pen, pen.view().px(piece.center), std::max(kLeastPx, radius));
    if (++count % 64 == 0) finishRings(pen);
  }
  finishRings(pen);
}

LegendItem passageLegend(std::size_t count) {
  return lineLegend(groupedCount(count, "passage", "passages"), ink::orange, kPassagePx);
}

LegendItem corridorAreaLegend(std::size_t count) {
  return {groupedCount(count, "corridor", "corridors"), [](const Pen& pen, Point at) {
            cairo_rectangle(pen.cairo(), at.x - 9, at.y - 6, 18, 12);
            pen.ink(ink::sky, 0.34);
            cairo_fill_preserve(pen.cairo());
            pen.ink(ink::blue, 0.7);
            pen.stroke(1.2);
          }};
}

LegendItem clutterLegend() {
  return {"clutter", [](const Pen& pen, Point at) {
            addRing(pen, at, 5);
            finishRings(pen);
          }};
}

}  // namespace roomgraph
