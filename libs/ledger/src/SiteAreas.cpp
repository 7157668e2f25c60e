#include "SiteAreas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fitted_ledger.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/grid/polygon_cells.h"

namespace roomgraph {
namespace {

AreaGraph moved(AreaGraph areas, const Transform2D& pose) {
  const Motion2D motion(pose);
  for (Area& area : areas.areas)
    forEachRing(area.polygon, [&](Ring& ring) {
      for (Point& p : ring) p = motion(p);
    });
  for (Passage& passage : areas.passages)
    passage.from = motion(passage.from), passage.to = motion(passage.to);
  return areas;
}

/** Every second cell both ways. */
bool isSample(Cell c) { return c.x % 2 == 0 && c.y % 2 == 0; }

/** Labels the cells of each area. */
void addShapes(const AreaGraph& areas, const GridFrame& frame, RunAreas& run) {
  for (std::size_t a = 0;
       a < std::min<std::size_t>(areas.areas.size(), UINT16_MAX - RunAreas::firstArea); ++a) {
    SiteShape shape;
    shape.polygon = areas.areas[a].polygon;
    shape.middle = centroid(shape.polygon);
    shape.area = area(shape.polygon);
    shape.isCorridor = !areas.areas[a].isRoom();
    for (const Cell c : cellsIn(shape.polygon, frame)) {
      run.labels[frame.index(c)] = std::uint16_t(RunAreas::firstArea + a);
      shape.size += isSample(c);
    }
    run.shapes.push_back(std::move(shape));
  }
  run.doors.resize(run.shapes.size());
  for (const Passage& passage : areas.passages) {
    if (!passage.b) continue;
    const std::size_t a = passage.a.index(), b = passage.b.index();
    if (a >= run.shapes.size() || b >= run.shapes.size()) continue;
    run.doors[a].push_back({b, passage.middle(), passage.width});
    run.doors[b].push_back({a, passage.middle(), passage.width});
  }
}

void markKnown(const WallMap& map, const Transform2D& pose, const GridFrame& frame, RunAreas& run) {
  const Motion2D back(pose.inverse());
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const State state = stateAt(map, back(frame.center({x, y})));
      if (state == State::unknown) continue;
      run.labels[frame.index({x, y})] = state == State::free ? RunAreas::free : RunAreas::occupied;
    }
}

}  // namespace

bool RunAreas::isOpenTo(std::size_t a, std::size_t b) const {
  return std::any_of(doors[a].begin(), doors[a].end(),
                     [&](const AreaDoor& door) { return door.to == b; });
}

GridFrame frameRound(const std::vector<const Polygon*>& polygons) {
  Box box;
  for (const Polygon* polygon : polygons)
    for (const Point p : polygon->outer) box.include(p);
  if (box.isEmpty()) return {0, 0, kWallCell, {}};
  box = box.widened(fitted::kMargin);
  const Point size = box.size();
  // A site has a million cells at most; a larger one has larger ones.
  const double cell = std::max(kWallCell, std::sqrt(size.x * size.y / 1e6));
  return {int(size.x / cell) + 1, int(size.y / cell) + 1, cell, box.low};
}

SiteShape sampled(SiteShape shape, const GridFrame& frame) {
  shape.samples.clear();
  shape.samples.reserve(shape.size);
  for (const Cell c : cellsIn(shape.polygon, frame))
    if (isSample(c)) shape.samples.push_back(frame.center(c));
  return shape;
}

SiteAreas siteAreas(const Site& site, const Trust& trust) {
  std::vector<AreaGraph> areas;
  std::vector<const Polygon*> polygons;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    areas.push_back(moved(site.runs[i]->areas, site.poses[i]));
  for (const AreaGraph& graph : areas)
    for (const Area& area : graph.areas) polygons.push_back(&area.polygon);
  SiteAreas result;
  result.frame = frameRound(polygons);
  const bool isTrusted = std::any_of(trust.begin(), trust.end(), [](double of) { return of > 0; });
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    RunAreas run;
    run.weight = isTrusted ? std::max(fitted::kLeastWeight, std::sqrt(std::sqrt(trust[i]))) : 1;
    run.labels.assign(result.frame.cellCount(), RunAreas::unknown);
    markKnown(site.runs[i]->map, site.poses[i], result.frame, run);
    addShapes(areas[i], result.frame, run);
    result.runs.push_back(std::move(run));
  }
  return result;
}

RunAreas areasIn(const AreaGraph& areas, const GridFrame& frame) {
  RunAreas run;
  run.weight = 1;
  run.labels.assign(frame.cellCount(), RunAreas::free);
  addShapes(areas, frame, run);
  for (SiteShape& shape : run.shapes) shape = sampled(std::move(shape), frame);
  return run;
}

}  // namespace roomgraph
