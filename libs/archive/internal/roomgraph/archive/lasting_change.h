#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace roomgraph {

// Ours
// In:   what each run says of a thing that may change once and for all, such as the doors of a room
// Out:  LastingChange
// Next: watchSite

/** From here on something is different, and stays so. */
struct LastingChange {
  std::size_t first = 0;         ///< index of the first value behind it
  double before = 0, after = 0;  ///< medians
};

/** The split of `values`, in the order of time, behind which they lie about another level; of
 *  equally good ones the first. Both sides have at least `least` values; a value is off where it is
 *  farther than half the tolerance from its side's level, and of each side one in four may be off.
 *  The levels are farther apart than the tolerance, and the split spares at least `least` values of
 *  being off. Nothing where there is no such split: one value that is off is no change.
 *  O(values^2). */
std::optional<LastingChange> lastingChange(const std::vector<double>& values, double tolerance,
                                           std::size_t least = 3);

/** All such changes, each as it was found when its first `least` values had come: a door that was
 *  walled up and opened again has two. Looks back sixty values at most. O(values), times
 *  lastingChange of sixty where values are off. */
std::vector<LastingChange> lastingChanges(const std::vector<double>& values, double tolerance,
                                          std::size_t least);

}  // namespace roomgraph
