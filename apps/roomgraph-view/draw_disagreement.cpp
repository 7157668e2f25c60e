#include "draw_disagreement.h"

#include <algorithm>
#include <cmath>

#include "heights.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/page/site_pictures.h"

namespace roomgraph {
namespace {

constexpr double kHeatCell = 0.2;  // no finer, so that turned maps leave no gaps [m]

std::vector<PlacedMap> placedMaps(const View& view) {
  std::vector<PlacedMap> placed;
  for (const ComparedRun& run : view.comparison.runs)
    if (const Run* map = view.runNamed(run.name))
      if (!map->map.states.empty()) placed.push_back({&map->map, run.pose});
  return placed;
}

void addSquare(const GridFrame& frame, Cell cell, Colour colour, viz::CSetOfTriangles& squares) {
  const Point middle = frame.center(cell);
  const double half = frame.resolution / 2;
  const auto at = [&](double x, double y) {
    return mrpt::math::TPoint3Df(float(middle.x + x * half), float(middle.y + y * half),
                                 float(kHeatHeight));
  };
  for (viz::TTriangle triangle : {viz::TTriangle(at(-1, -1), at(1, -1), at(1, 1)),
                                  viz::TTriangle(at(-1, -1), at(1, 1), at(-1, 1))}) {
    triangle.setColor(mrptColour(colour));
    squares.insertTriangle(triangle);
  }
}

}  // namespace

viz::CSetOfObjects::Ptr drawDisagreement(const View& view) {
  auto set = viz::CSetOfObjects::Create();
  const std::vector<PlacedMap> maps = placedMaps(view);
  if (maps.size() < 2) return set;
  double cell = kHeatCell;
  for (const PlacedMap& placed : maps) cell = std::max(cell, 2 * placed.map->frame.resolution);
  const Disagreement found = disagreementOf(maps, cell);
  auto squares = viz::CSetOfTriangles::Create();
  squares->enableLight(false);
  for (int y = 0; y < found.frame.height; ++y)
    for (int x = 0; x < found.frame.width; ++x) {
      const int level = heatLevel(double(found.shares[found.frame.index({x, y})]));
      if (level > 0)
        addSquare(found.frame, {x, y}, heatColours()[std::size_t(level - 1)], *squares);
    }
  set->insert(squares);
  return set;
}

}  // namespace roomgraph
