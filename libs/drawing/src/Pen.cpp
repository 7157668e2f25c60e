#include "Pen.h"

#include <cmath>

#include "roomgraph/base/printable.h"
#include "roomgraph/geometry/thinned_line.h"

namespace roomgraph {
namespace {

void traceDiamond(cairo_t* cairo, Point px, double half) {
  cairo_move_to(cairo, px.x, px.y - half);
  cairo_line_to(cairo, px.x + half, px.y);
  cairo_line_to(cairo, px.x, px.y + half);
  cairo_line_to(cairo, px.x - half, px.y);
  cairo_close_path(cairo);
}

}  // namespace

void Pen::ink(Colour c, double alpha) const {
  cairo_set_source_rgba(cairo_, c.red / 255.0, c.green / 255.0, c.blue / 255.0, alpha);
}

void Pen::trace(const Polyline& line) const {
  Polyline px;
  for (const Point p : line) px.push_back(view_.px(p));
  const Polyline thinned = thinnedLine(px, 0.3);
  for (std::size_t i = 0; i < thinned.size(); ++i)
    (i == 0 ? cairo_move_to : cairo_line_to)(cairo_, thinned[i].x, thinned[i].y);
}

void Pen::trace(const Polygon& polygon) const {
  forEachRing(polygon, [&](const Ring& ring) {
    trace(ring);
    if (!ring.empty()) cairo_close_path(cairo_);
  });
}

void Pen::traceDisc(Point px, double radiusPx) const {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, px.x, px.y, radiusPx, 0, 2 * M_PI);
}

void Pen::traceBox(Point px, Point halfPx) const {
  cairo_rectangle(cairo_, px.x - halfPx.x, px.y - halfPx.y, 2 * halfPx.x, 2 * halfPx.y);
}

void Pen::paint(Colour fill, double fillAlpha, Colour edge, double edgeAlpha,
                double widthPx) const {
  ink(fill, fillAlpha);
  cairo_fill_preserve(cairo_);
  ink(edge, edgeAlpha);
  stroke(widthPx);
}

void Pen::stroke(double widthPx) const {
  cairo_set_line_width(cairo_, widthPx);
  cairo_stroke(cairo_);
}

void Pen::mark(VertexKind kind, Point px) const {
  Colour fill = ink::blue, edge = ink::paper;
  switch (kind) {
    case VertexKind::junction:
      traceDisc(px, 3.4);
      break;
    case VertexKind::deadEnd:
      traceBox(px, {3.2, 3.2});
      fill = ink::vermilion;
      break;
    case VertexKind::border:
      traceDiamond(cairo_, px, 5);
      fill = ink::yellow;
      edge = ink::text;
      break;
    case VertexKind::room:
      traceDisc(px, 5);
      fill = ink::paper;
      edge = ink::inside;
      break;
    case VertexKind::ring:
      traceDisc(px, 4.2);
      fill = ink::paper;
      edge = ink::blue;
      break;
  }
  paint(fill, 1, edge, 1, kind == VertexKind::ring || kind == VertexKind::room ? 1.8 : 1);
}

void Pen::font(double sizePx, bool isBold) const {
  cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         isBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, sizePx);
}

double Pen::textWidth(const std::string& line, double sizePx, bool isBold) const {
  font(sizePx, isBold);
  cairo_text_extents_t extents;
  // cairo refuses to draw anything more after one bad character.
  cairo_text_extents(cairo_, printable(line).c_str(), &extents);
  return extents.x_advance;
}

void Pen::text(const std::string& line, Point place, double sizePx, bool isBold,
               Align align) const {
  const double before = align == Align::left ? 0 : textWidth(line, sizePx, isBold) / 2;
  font(sizePx, isBold);
  cairo_move_to(cairo_, place.x - before, place.y);
  cairo_show_text(cairo_, printable(line).c_str());
}

}  // namespace roomgraph
