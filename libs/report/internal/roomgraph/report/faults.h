#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

// In:   RunCheck or Comparison
// Out:  which scans to lay over each other to see what is wrong, and where
// Next: pages, scenes, logs and windows

/** What is wrong with what a run has drawn. */
enum class FaultKind {
  broken,   ///< it breaks between two key frames
  doubled,  ///< it has drawn one place twice
  welded    ///< it has drawn two places over each other
};

/** What they are called in the names of files. */
[[nodiscard]] constexpr std::array<const char*, 3> enumNames(FaultKind) {
  return {"break", "doubled", "welded"};
}

/** Two times of a run that do not fit each other as it has drawn them. */
struct Fault {
  FaultKind kind = FaultKind::broken;
  std::size_t number = 1;               ///< of its kind
  std::string run, text;                ///< its name; for people
  Point place;                          ///< where the earlier time has drawn it [m]
  std::optional<std::size_t> keyFrame;  ///< at which the later time is shown
  KeyFrames earlier, later;             ///< those that are shown; none of a run without scans
  std::optional<Transform2D> mend;      ///< lays the later time on the earlier one, if it is known

  /** "break1", as in the names of files. */
  [[nodiscard]] std::string name() const { return nameOf(kind) + std::to_string(number); }
};

/** The breaks of a comparison, in their order there; in the frame of the site. */
std::vector<Fault> faultsOf(const Comparison& comparison);

/** The breaks of a run by itself, what it has drawn twice, and what lies over each other; in its
 *  own frame. */
std::vector<Fault> faultsOf(const RunCheck& check);

}  // namespace roomgraph
