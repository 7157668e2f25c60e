#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/archive/SiteHistory.h"
#include "roomgraph/archive/watch_errors.h"

namespace roomgraph {

// In:   SiteHistory
// Out:  SiteWatch
// Next: historyText, historyJson

/** Whether the latest map of a robot may be rolled out. */
enum class Rollout { yes, no, unknown };

/** What the maps of one robot say, over time. */
struct RobotWatch {
  std::string robot;
  std::vector<std::size_t> runs;  ///< whose errors can be trusted: indices into SiteHistory::runs
  ErrorWatch errors;              ///< its indices are ones into `runs`
  std::optional<std::size_t> lastGood;  ///< into SiteHistory::runs: may be rolled out
  std::size_t latest = 0;               ///< into SiteHistory::runs
  /** Latest runs in a row that lie elsewhere, or cannot be judged though the site is known. */
  std::size_t unjudged = 0;
  /** Of `latest`: yes where it is judged, has slight breaks at most, is not above the limit, shows
   *  nearly all of the site, lacks or adds few walls, and draws them about as thick as others;
   *  unknown while the site has fewer than three runs. */
  Rollout rollout = Rollout::unknown;
  std::string advice;    ///< for people: whether it may, why not, and which map stays
  std::string sentence;  ///< for people, without the name of the robot: what is seen over time

  /** The maps get worse, or two nights in a row tell nothing of them. */
  bool isAlarm() const { return errors.isAlarm() || isLost(); }
  bool isLost() const { return unjudged > 1; }
};

/** A room that is different for good. */
struct RoomChange {
  std::string room;              ///< id
  std::string what;              ///< "seen", "doors" or "area"
  std::size_t run = 0;           ///< the first run that has it so: index into SiteHistory::runs
  double before = 0, after = 0;  ///< 0 or 1; a number of doors; [m2]
};

/** What the history of a site tells. */
struct SiteWatch {
  std::vector<RobotWatch> robots;   ///< by name
  std::vector<RoomChange> changes;  ///< by time, then by room
};

/** Judges each robot by watchErrors, and says which rooms have changed and stayed so: five runs
 *  must agree. Rooms are judged by placed runs without a break. Runs of another site and errors
 *  that cannot be trusted count for nothing in the trend, and against the robot in `unjudged`.
 *  O(runs * (window^2 + rooms)). */
SiteWatch watchSite(const SiteHistory& history, const WatchOptions& options);

/** What was known of a site when one of its runs had come: without later ones, in time. All of it
 *  where no run has that content. */
SiteHistory historyUpTo(SiteHistory history, const std::string& sha256);

/** One line for people: "R3 Kitchen: 2 doors instead of 3 since 2026-11-02". */
std::string changeText(const RoomChange& change, const SiteHistory& history);

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
