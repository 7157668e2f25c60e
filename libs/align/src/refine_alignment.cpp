#include "roomgraph/align/refine_alignment.h"

#include "roomgraph/align/WallFit.h"

namespace roomgraph {

Transform2D refineAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                            const Look& look) {
  if (a.walls.empty() || b.walls.empty()) return pose;
  const std::size_t strideA = strideOf(a, look.refinePoints);
  const std::size_t strideB = strideOf(b, look.refinePoints);
  const auto addWalls = [&](WallFit& fit, int) {
    for (std::size_t i = 0; i < b.walls.size(); i += strideB) fit.add(b.walls[i], a);
    const Motion2D& forth = fit.forth();
    const Motion2D back(fit.pose().inverse());
    for (std::size_t i = 0; i < a.walls.size(); i += strideA) {
      const Point place = back(a.walls[i].place);
      const WallPoint* wall = nearestWall(b, place, back.turned(a.walls[i].normal));
      if (wall) fit.add(forth(wall->place), {a.walls[i].place, forth.turned(wall->normal)});
    }
  };
  return fittedPose(pose, b.middle(), look.band, addWalls, kShiftHold);
}

}  // namespace roomgraph
