#include "fit_shape.h"

#include <algorithm>

#include "fitted_ledger.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** The best of each area so far. */
class Search {
 public:
  Search(const SiteShape& room, const GridFrame& frame, const RunAreas& run, double reach)
      : room_(room), frame_(frame), run_(run), reach_(reach) {}

  struct Found {
    ShapeFit fit;
    RoomMove start;
    double value = 0;
  };

  /** Keeps the move for each area that it is better for. */
  void look(const RoomMove& move, const RoomMove& start) {
    if (distance(move.shift, start.shift) > reach_ + kSameStart.place) return;
    const Footprint print = footprint(room_, move, frame_, run_, buffer_);
    if (print.known < kMajority * print.samples) return;
    for (const auto& [area, common] : print.in) {
      const double overlap = overlapOf(print, area, common);
      const double value = overlap - fitted::kMoveCost * norm(move.shift - start.shift);
      Found& best = found_[area];
      if (value > best.value) best = {{move, overlap}, start, value};
    }
  }

  double best() const {
    double most = 0;
    for (const auto& [area, found] : found_) most = std::max(most, found.fit.overlap);
    return most;
  }

  /** Walks from the best move of `area` to better ones. */
  void refine(std::size_t area) {
    double step = kSameStart.place, turn = fitted::kFirstTurn;
    for (int halving = 0; halving < fitted::kHalvings;) {
      const Found before = found_[area];
      const RoomMove& at = before.fit.move;
      for (const RoomMove& by :
           {RoomMove{{step, 0}, 0}, RoomMove{{-step, 0}, 0}, RoomMove{{0, step}, 0},
            RoomMove{{0, -step}, 0}, RoomMove{{}, turn}, RoomMove{{}, -turn}})
        look({at.shift + by.shift, at.turn + by.turn}, before.start);
      if (found_[area].value > before.value) continue;
      step /= 2, turn /= 2, ++halving;
    }
  }

  std::map<std::size_t, Found>& found() { return found_; }

 private:
  double overlapOf(const Footprint& print, std::size_t area, double common) const {
    const double either = print.known + double(run_.shapes[area].size) - common;
    return either > 0 ? common / either : 0;
  }

  const SiteShape& room_;
  const GridFrame& frame_;
  const RunAreas& run_;
  double reach_;
  LabelCounts buffer_;
  std::map<std::size_t, Found> found_;
};

void searchRound(const RoomMove& start, double reach, Search& search) {
  const double raster = kNearSearch.reach;
  const int count = int(reach / raster);
  for (int y = -count; y <= count; ++y)
    for (int x = -count; x <= count; ++x) {
      const Point by{x * raster, y * raster};
      if ((x != 0 || y != 0) && norm(by) <= reach + 1e-9)
        search.look({start.shift + by, start.turn}, start);
    }
}

}  // namespace

Footprint footprint(const SiteShape& room, const RoomMove& move, const GridFrame& frame,
                    const RunAreas& run, LabelCounts& buffer) {
  const Motion2D motion(move.about(room.middle));
  const bool isStill = move.shift == Point{} && move.turn == 0;
  auto& [counts, met] = buffer;
  counts.resize(std::max(counts.size(), run.shapes.size() + RunAreas::firstArea));
  for (const Point p : room.samples) {
    const std::size_t cell = cellIndexAt(frame, isStill ? p : motion(p));
    std::uint16_t label = RunAreas::unknown;
    if (cell < run.labels.size()) label = run.labels[cell];
    if (counts[label] == 0) met.push_back(label);
    ++counts[label];
  }
  Footprint print;
  print.samples = double(room.samples.size());
  print.known = print.samples - counts[RunAreas::unknown];
  print.free = print.known - counts[RunAreas::occupied];
  for (const std::uint16_t label : met)
    if (label >= RunAreas::firstArea) print.in[label - RunAreas::firstArea] = counts[label];
  // A room meets few of the areas of a large site.
  for (const std::uint16_t label : met) counts[label] = 0;
  met.clear();
  return print;
}

std::map<std::size_t, ShapeFit> fitShape(const SiteShape& room, const GridFrame& frame,
                                         const RunAreas& run, const std::vector<RoomMove>& starts,
                                         const ShapeSearch& how) {
  Search search(room, frame, run, how.reach);
  for (const RoomMove& start : starts) search.look(start, start);
  if (search.best() < how.good)
    for (const RoomMove& start : starts) searchRound(start, how.reach, search);
  std::vector<std::pair<double, std::size_t>> areas;  // -overlap, area
  for (const auto& [area, found] : search.found())
    if (found.fit.overlap >= fitted::kLeastOverlap) areas.emplace_back(-found.fit.overlap, area);
  std::sort(areas.begin(), areas.end());
  if (areas.size() > fitted::kMostAreas) areas.resize(fitted::kMostAreas);
  std::map<std::size_t, ShapeFit> fits;
  for (const auto& [overlap, area] : areas) {
    if (how.isRefined) search.refine(area);
    fits[area] = search.found()[area].fit;
  }
  return fits;
}

}  // namespace roomgraph
