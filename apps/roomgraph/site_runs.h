#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/consensus/site_consensus.h"

namespace roomgraph {

/** What `compare`, `repair`, `merge` and `carry` are told of the runs that they work with. */
struct SiteArguments {
  std::vector<std::string> files;
  std::vector<std::string> needed;  ///< those of them without which there is nothing to do
  std::string reference, folder;
  std::string cache;         ///< folder that keeps pairs from call to call; empty for none
  bool areOneSite = false;   ///< they are said to show one
  bool takesCopies = false;  ///< else a run is left out that is a copy of another
  OptionArguments options;
  RunningArguments running;
};

/** How the runs are read and compared; a file that cannot be used is a line on stderr, a
 *  needed one a DataError. */
CompareMapsOptions siteOptions(const SiteArguments& arguments);

/** Declares --output, --reference, --cache and how maps are read; not the files themselves. */
void declareSite(SiteArguments& arguments, const std::string& results, CLI::App& app);

/** Runs that were read and related, and all that they tell together. */
struct SolvedRuns {
  ReadRuns read;
  SolvedSite solved;  ///< of `read.runs`, so this is not to be copied or moved

  /** What a command ends with that could do the rest. */
  ExitCode exitCode() const { return read.leftOut.empty() ? kDone : kBadData; }
};

/** Reads, relates and solves as `compare` does, and tells on stderr what is left out. */
std::unique_ptr<SolvedRuns> solvedRunsOf(const SiteArguments& arguments);

/** Names on stderr the runs that no pair places surely among the others: a building that repeats
 *  itself may have them somewhere else. */
void printUnplaced(const SolvedRuns& runs);

}  // namespace roomgraph
