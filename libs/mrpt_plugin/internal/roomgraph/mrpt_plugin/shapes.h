#pragma once
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/geometry/Point.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

// Shapes of one colour, level at a height [m].

inline viz::CPointCloud::Ptr pointsAt(const std::vector<Point>& places, double height,
                                      const mrpt::img::TColor& colour, float sizePx) {
  auto points = viz::CPointCloud::Create();
  points->setColor_u8(colour);
  points->setPointSize(sizePx);
  for (const Point p : places) points->insertPoint(float(p.x), float(p.y), float(height));
  return points;
}

/** A ring, where `hole` is the radius of what it leaves free [m]. */
inline viz::CDisk::Ptr diskAt(Point place, double height, const mrpt::img::TColor& colour,
                              double radius, double hole = 0) {
  auto disk = viz::CDisk::Create(float(radius), float(hole));
  disk->setColor_u8(colour);
  disk->setLocation(place.x, place.y, height);
  return disk;
}

using Segment = std::pair<Point, Point>;

inline viz::CSetOfLines::Ptr linesAt(const std::vector<Segment>& segments, double height,
                                     const mrpt::img::TColor& colour, float widthPx) {
  auto lines = viz::CSetOfLines::Create();
  lines->setColor_u8(colour);
  lines->setLineWidth(widthPx);
  for (const auto& [a, b] : segments) lines->appendLine(a.x, a.y, height, b.x, b.y, height);
  return lines;
}

inline viz::CSetOfObjects::Ptr setNamed(const std::string& name) {
  auto set = viz::CSetOfObjects::Create();
  set->setName(name);
  return set;
}

}  // namespace roomgraph
