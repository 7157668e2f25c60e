#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "roomgraph/ledger/SiteFile.h"
#include "site_runs.h"

namespace roomgraph {

/** What `roomgraph merge` and `archive merge` are told. */
struct MergeArguments : SiteArguments {
  bool prefersLatest = false;
  std::string names;  ///< file of the rooms of the site, kept up to date; empty for none
  std::optional<SiteFile> known;  ///< these rooms instead of those of a file
};

/** Declares --latest and how runs are read and related; not the runs, nor their names. */
void declareMerging(MergeArguments& arguments, CLI::App& app);

/** Makes one map of the runs and writes it; gives the exit code. */
int mergeSite(const MergeArguments& arguments);

}  // namespace roomgraph
