#include "drift.h"

#include <cmath>

#include "Random.h"

namespace roomgraph {

std::vector<Transform2D> drift(const std::vector<WalkPose>& poses, const Transform2D& start,
                               const DriftOptions& options) {
  Random random(options.seed);
  std::vector<Transform2D> believed;
  Transform2D before;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Transform2D now{poses[i].place.x, poses[i].place.y, poses[i].heading};
    if (i == 0) {
      believed.push_back(start);
    } else {
      Transform2D step = before.inverse() * now;
      const double way = norm(step.shift());
      step.phi += options.turnPerMetre * way + options.turnNoise * std::sqrt(way) * random.normal();
      if (i == options.breakAt) step.phi += options.breakTurn;
      believed.push_back(believed.back() * step);
    }
    before = now;
  }
  return believed;
}

}  // namespace roomgraph
