#include "SiteAreas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "RealPlaces.h"
#include "fitted_ledger.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/MotionFit.h"
#include "roomgraph/grid/polygon_cells.h"

namespace roomgraph {
namespace {

/** Every second cell both ways. */
bool isSample(Cell c) { return c.x % 2 == 0 && c.y % 2 == 0; }

/** As most of an area really lies: site <- run. */
Transform2D realPose(const Polygon& polygon, const GridFrame& frame, const RealPlaces& places) {
  MotionFit fit;
  const auto add = [&](Point place) { fit.add(place, places.at(place)(place)); };
  for (const Point corner : polygon.outer) add(corner);  // where it is smaller than a cell
  for (const Cell c : cellsIn(polygon, frame))
    if (isSample(c)) add(frame.center(c));
  return fit.motion();
}

/** The areas of a run, each where it really lies. */
struct LaidDown {
  std::vector<Transform2D> poses;  // site <- run
  std::vector<Polygon> polygons;

  LaidDown(const Run& run, const RealPlaces& places) {
    for (const Area& area : run.areas.areas) {
      poses.push_back(realPose(area.polygon, run.map.frame, places));
      polygons.push_back(movedBy(area.polygon, Motion2D(poses.back())));
    }
  }
};

/** Adds areas with these shapes, and labels their cells. `poses`: site <- run, for their doors. */
void addShapes(const AreaGraph& areas, const std::vector<Transform2D>& poses,
               std::vector<Polygon> polygons, const GridFrame& frame, RunAreas& run) {
  const std::size_t count =
      std::min<std::size_t>(polygons.size(), UINT16_MAX - RunAreas::firstArea);
  for (std::size_t a = 0; a < count; ++a) {
    SiteShape shape;
    shape.polygon = std::move(polygons[a]);
    shape.middle = shape.drawn = centroid(shape.polygon);
    shape.area = area(shape.polygon);
    shape.isCorridor = !areas.areas[a].isRoom();
    for (const Cell c : cellsIn(shape.polygon, frame)) {
      run.labels[frame.index(c)] = std::uint16_t(RunAreas::firstArea + a);
      shape.size += isSample(c);
    }
    run.shapes.push_back(std::move(shape));
  }
  run.doors.resize(count);
  for (const Passage& passage : areas.passages) {
    if (!passage.b) continue;
    const std::size_t a = passage.a.index(), b = passage.b.index();
    if (a >= count || b >= count) continue;
    run.doors[a].push_back({b, poses[a](passage.from), poses[a](passage.to)});
    run.doors[b].push_back({a, poses[b](passage.from), poses[b](passage.to)});
  }
}

/** Labels the cells that a run knows, each where it really lies: by its quarters, so that none of
 *  the frame is missed, where that has cells no larger than the map. */
void markKnown(const WallMap& map, const RealPlaces& places, const GridFrame& frame,
               RunAreas& run) {
  std::vector<std::int8_t> walls(frame.cellCount());  // parts, less those that are free
  std::vector<Point> parts{{0, 0}};
  if (const double side = map.frame.resolution / 4; frame.resolution <= 4 * side)
    parts = {{-side, -side}, {-side, side}, {side, -side}, {side, side}};
  for (int y = 0; y < map.frame.height; ++y)
    for (int x = 0; x < map.frame.width; ++x) {
      const State state = map.states[map.frame.index({x, y})];
      if (state == State::unknown) continue;
      const Point middle = map.frame.center({x, y});
      const Motion2D& motion = places.at(middle);
      for (const Point part : parts) {
        const Cell there = frame.cellAt(motion(middle + part));
        if (!frame.contains(there)) continue;
        const std::size_t cell = frame.index(there);
        std::int8_t& wall = walls[cell];
        wall = std::int8_t(std::clamp(wall + (state == State::free ? -1 : 1), -100, 100));
        run.labels[cell] = wall < 0 ? RunAreas::free : RunAreas::occupied;
        run.isWall[cell] = wall >= 0;
      }
    }
}

}  // namespace

bool RunAreas::isOpenTo(std::size_t a, std::size_t b) const {
  return anyOf(doors[a], [&](const AreaDoor& door) { return door.to == b; });
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

SiteAreas siteAreas(const Site& site, const Consensus& consensus, const Trust& trust) {
  const Transform2D frame = frameOfConsensus(site, consensus, trust);
  std::vector<RealPlaces> places;
  std::vector<LaidDown> laidDown;
  std::vector<const Polygon*> polygons;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    places.emplace_back(site, consensus, frame, i);
    laidDown.emplace_back(*site.runs[i], places[i]);
  }
  for (const LaidDown& of : laidDown)
    for (const Polygon& polygon : of.polygons) polygons.push_back(&polygon);
  SiteAreas result;
  result.frame = frameRound(polygons);
  const bool isTrusted = anyOf(trust, [](double of) { return of > 0; });
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    RunAreas run;
    run.weight = isTrusted ? std::max(fitted::kLeastWeight, std::sqrt(std::sqrt(trust[i]))) : 1;
    run.labels.assign(result.frame.cellCount(), RunAreas::unknown);
    run.isWall.assign(result.frame.cellCount(), false);
    markKnown(site.runs[i]->map, places[i], result.frame, run);
    auto& [poses, shapes] = laidDown[i];
    addShapes(site.runs[i]->areas, poses, std::move(shapes), result.frame, run);
    for (std::size_t a = 0; a < run.shapes.size(); ++a)
      run.shapes[a].drawn = site.poses[i](poses[a].inverse()(run.shapes[a].middle));
    result.runs.push_back(std::move(run));
  }
  return result;
}

RunAreas areasIn(const AreaGraph& areas, const GridFrame& frame) {
  RunAreas run;
  run.weight = 1;
  run.labels.assign(frame.cellCount(), RunAreas::free);
  run.isWall.assign(frame.cellCount(), false);
  addShapes(areas, std::vector<Transform2D>(areas.areas.size()),
            mapped(areas.areas, &Area::polygon), frame, run);
  for (SiteShape& shape : run.shapes) shape = sampled(std::move(shape), frame);
  return run;
}

}  // namespace roomgraph
