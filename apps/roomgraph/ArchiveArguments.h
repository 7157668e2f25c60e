#pragma once
#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "merge_site.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/archive/add_run.h"
#include "roomgraph/archive/watch_site.h"

namespace roomgraph {

/** What is asked of `roomgraph archive`, of which 'merge' works as `roomgraph merge` does, and of
 *  `roomgraph watch`. */
struct ArchiveArguments : MergeArguments {
  std::string archive;
  std::string site;  ///< empty for the only one, or the name of the archive
  std::string robot = "robot", time, kept;
  std::size_t most = AddRunOptions().most;
  WatchOptions watch;
  std::string format = "csv", output, page;
  std::string room, name;  ///< a room's id or a robot, and the name that it is to have
  std::string run;         ///< that is to be taken out
  bool repairs = false;    ///< keeps mended runs, too
  bool failsOnAlarm = false, failsOnLatest = false;
};

/** Declares --site. */
void declareSite(ArchiveArguments& arguments, CLI::App& app);
/** Declares --limit. */
void declareWatch(ArchiveArguments& arguments, CLI::App& app);
/** Declares how runs are added: --site, --robot, --quiet and so on. */
void declareAdding(ArchiveArguments& arguments, CLI::App& app);

/** The files of at most `most` runs of a site, as 'archive add' chooses those that it compares
 *  with; tells on stderr of those that are gone. */
std::vector<std::string> recordFiles(const Archive& archive, const std::string& site,
                                     std::size_t most);

/** The file of a run as somebody calls it, see namedRun. @throws DataError where there is no such
 *  run, or its file is gone or another one now. */
std::string fileOfRun(const Archive& archive, const std::string& site, const std::string& run,
                      const std::string& archiveFile);

}  // namespace roomgraph
