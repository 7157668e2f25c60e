#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/Archive.h"

namespace roomgraph::test {

constexpr auto kOrNew = Archive::Access::orNew;

/** A run "N" of sha256 "N" that lies in its site with this map error. */
ComparedRun comparedRun(const std::string& name, double error, bool isMeaningful = true);

/** A square room of 16 m2 with its lower left corner there, seen by runs; doors on its sides. */
SiteRoom squareRoom(const std::string& id, Point corner, const std::vector<std::string>& seenBy,
                    std::size_t doors = 1);

/** Night n of a robot: the run "n" among those before it that are named. */
Addition night(const std::string& site, const std::string& robot, int n, double error,
               const std::vector<std::string>& others = {}, bool isMeaningful = true);

/** The same as a run of a history, on day n. */
HistoryRun historyRun(const std::string& robot, int n, double error);

}  // namespace roomgraph::test
