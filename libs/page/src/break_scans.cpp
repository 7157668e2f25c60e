#include "break_scans.h"

#include <algorithm>

#include "roomgraph/breaks/frames_at_break.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMostDotsOfScans = 250;

std::vector<Point> thinned(const std::vector<Point>& places) {
  const std::size_t step = (places.size() + kMostDotsOfScans - 1) / kMostDotsOfScans;
  std::vector<Point> some;
  for (std::size_t i = 0; i < places.size(); i += std::max<std::size_t>(1, step))
    some.push_back(places[i]);
  return some;
}

}  // namespace

BreakScans breakScans(const Comparison& comparison, const MapBreak& tear,
                      const std::vector<Run>& runs) {
  const auto isTorn = [&](const auto& run) { return run.name == tear.run; };
  const auto run = std::find_if(runs.begin(), runs.end(), isTorn);
  const auto placed = std::find_if(comparison.runs.begin(), comparison.runs.end(), isTorn);
  if (run == runs.end() || placed == comparison.runs.end()) return {};
  const Motion2D move(placed->pose);
  BreakScans scans;
  const FramesAtBreak frames = framesAtBreak(tear, run->scans);
  for (std::size_t k = frames.first; k < frames.end; ++k)
    for (const WallPoint& wall : run->scans[k].walls)
      (k < frames.behind ? scans.before : scans.behind).push_back(move(wall.place));
  return {thinned(scans.before), thinned(scans.behind)};
}

}  // namespace roomgraph
