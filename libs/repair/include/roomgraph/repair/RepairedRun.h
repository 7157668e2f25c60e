#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/geometry/PlanarCovariance.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

enum class RepairState {
  mended,    ///< its key frames lie where all runs together, or it alone, have them
  kept,      ///< left as it was: it would not get better, or nothing tells where it really lies
  reference  ///< counts as the truth, so it is left as it was
};

[[nodiscard]] constexpr std::array<const char*, 3> enumNames(RepairState) {
  return {"mended", "kept", "reference"};
}

/** A run after its repair. Poses are those of its scans, in their order: run <- robot. */
struct RepairedRun {
  std::size_t run = 0, siteRun = 0;  ///< its place among all runs, and in the site
  RepairState state = RepairState::kept;
  std::string reason;              ///< of the state, one line
  std::vector<Transform2D> poses;  ///< in the run's own frame; as they were unless it is mended
  /** How sure `poses` are, in the same frame; none where nothing was worked out. */
  std::vector<PlanarCovariance> covariances;
  Transform2D frame;                ///< run <- site: where its sound majority stays as it was
  double moved = 0, movedMost = 0;  ///< how far scans lie from where they were, RMS and largest [m]
  std::size_t movedMostAt = 0;      ///< the key frame that has moved farthest
  /** How far its scans still lie from where they fit on what the others have drawn, RMS [m]; none
   *  unless others have mended it. */
  std::optional<double> left;
  std::vector<KeyFrames> unseen;  ///< what no other run, or pass, has seen: it stays on its links

  /** One key frame alone, of which people speak in the singular. */
  [[nodiscard]] bool isOneUnseen() const {
    return unseen.size() == 1 && unseen[0].from == unseen[0].to;
  }
};

}  // namespace roomgraph
