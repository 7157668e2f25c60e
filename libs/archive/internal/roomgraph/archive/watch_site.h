#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/archive/SiteHistory.h"
#include "roomgraph/archive/watch_errors.h"

namespace roomgraph {

// Ours
// In:   SiteHistory
// Out:  SiteWatch
// Next: historyText, historyJson

/** What the maps of one robot say, over time. */
struct RobotWatch {
  std::string robot;
  std::vector<std::size_t> runs;  ///< whose errors can be trusted: indices into SiteHistory::runs
  ErrorWatch errors;              ///< its indices are ones into `runs`
  std::optional<std::size_t> lastGood;  ///< into SiteHistory::runs: not above the limit, not torn
  std::size_t latest = 0;               ///< into SiteHistory::runs
  std::string sentence;                 ///< for people, without the name of the robot
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
 *  that cannot be trusted count for nothing. O(runs * (window^2 + rooms)). */
SiteWatch watchSite(const SiteHistory& history, const WatchOptions& options);

/** One line for people: "R3 Kitchen: 2 doors instead of 3 since 2026-11-02". */
std::string changeText(const RoomChange& change, const SiteHistory& history);

}  // namespace roomgraph
