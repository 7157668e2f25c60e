#pragma once
#include <cairo.h>

#include <string>

#include "View.h"
#include "roomgraph/drawing/ink.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** Draws things of the map on a cairo context whose origin is the view's upper left corner. What is
 *  measured in px here stays the same however large the map is. */
class Pen {
 public:
  Pen(cairo_t* cairo, const View& view) : cairo_(cairo), view_(view) {}

  cairo_t* cairo() const { return cairo_; }
  const View& view() const { return view_; }

  void ink(Colour colour, double alpha = 1) const;

  /** Adds to cairo's current path; points that make no visible difference are left out. */
  void trace(const Polyline& line) const;
  void trace(const Polygon& polygon) const;
  void traceDisc(Point px, double radiusPx) const;
  void traceBox(Point px, Point halfPx) const;  ///< round a place on the picture
  void stroke(double widthPx) const;
  /** Fills cairo's current path, and strokes it in another ink. */
  void paint(Colour fill, double fillAlpha, Colour edge, double edgeAlpha, double widthPx) const;

  /** The mark of a vertex at a place on the picture: a shape and a colour for each kind. */
  void mark(VertexKind kind, Point px) const;

  enum class Align { left, centre };
  /** One line of text; `at` is on its base line. What is not UTF-8 becomes '?'. */
  void text(const std::string& line, Point at, double sizePx, bool isBold, Align align) const;
  double textWidth(const std::string& line, double sizePx, bool isBold) const;

 private:
  void font(double sizePx, bool isBold) const;

  cairo_t* cairo_;
  const View& view_;
};

}  // namespace roomgraph
