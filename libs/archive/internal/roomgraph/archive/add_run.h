#pragma once
#include <functional>
#include <optional>
#include <string>

#include "roomgraph/archive/Archive.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

// In:   a map file, and Archive
// Out:  Archive with one run more
// Next: watchSite

struct AddRunOptions {
  std::string site, robot;
  std::optional<double> time;  ///< of the run [s since 1970]; none for what the file tells
  std::size_t most = 8;        ///< runs that it is compared with
  CompareMapsOptions compare;  ///< without a reference
  std::string kept;            ///< folder for a copy of the map, see keepMap; empty for none
  /** Told of each run that would be compared with, but whose file is gone or another one now. */
  std::function<void(const HistoryRun&)> onMissing = [](const HistoryRun&) {};
};

/** What became of a run. */
struct AddedRun {
  std::string sha256;     ///< of its content
  bool wasKnown = false;  ///< its content is there already: nothing was compared, nothing changed
  bool isPlaced = false;  ///< it lies in the site
  std::optional<RunScore> score;  ///< of the comparison
  std::string reason;             ///< of the score, or why there is none
  std::string roomsFailed;        ///< as in Added
};

/** Compares a map with a choice of the runs of its site, see chooseRecord, and keeps what comes
 *  out. The archive knows where their files lie, and what they held; those that are gone or have
 *  changed are not compared with. Its time is that of its scans, else that of the file. Costs the
 *  same for any number of runs in the archive.
 *  @throws DataError where the map cannot be used, or the archive cannot be written. */
AddedRun addRun(Archive& archive, const std::string& file, const AddRunOptions& options);

}  // namespace roomgraph
