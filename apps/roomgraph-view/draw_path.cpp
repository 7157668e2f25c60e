#include "draw_path.h"

#include <algorithm>

#include "heights.h"

namespace roomgraph {
namespace {

constexpr float kDotRadius = 0.08f;  // of a key frame [m]

}  // namespace

mrpt::img::TColor colourOfError(const std::optional<double>& error) {
  if (!error) return {0, 82, 155};
  const double bad = std::clamp(*error / kWorstError, 0.0, 1.0);
  return {std::uint8_t(230 * std::min(1.0, 2 * bad)),
          std::uint8_t(170 * std::min(1.0, 2 - 2 * bad)), 40};
}

viz::CSetOfObjects::Ptr drawPath(const std::vector<PathPose>& path) {
  auto set = viz::CSetOfObjects::Create();
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    auto piece = viz::CSetOfLines::Create();
    piece->setLineWidth(3);
    piece->setColor_u8(colourOfError(path[k + 1].error));
    const Transform2D &a = path[k].pose, &b = path[k + 1].pose;
    piece->appendLine(a.x, a.y, kPathHeight, b.x, b.y, kPathHeight);
    set->insert(piece);
  }
  for (const PathPose& at : path) {
    auto disk = viz::CDisk::Create(kDotRadius, 0.0f);
    disk->setColor_u8(colourOfError(at.error));
    disk->setLocation(at.pose.x, at.pose.y, kPathHeight);
    set->insert(disk);
  }
  return set;
}

}  // namespace roomgraph
