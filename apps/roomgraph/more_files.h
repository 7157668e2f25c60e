#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ResultFolder.h"
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/ledger/SiteFile.h"
#include "roomgraph/pipeline/ExtractOptions.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** The rooms of a site as a file of names knows them; nothing where there is no such file. */
SiteFile readSite(const std::string& file);

/** The names of the files that addTrajectories() and addSiteMaps() may add, of runs of these
 *  names. */
std::vector<std::string> trajectoryNames(const std::vector<std::string>& runs);
std::vector<std::string> siteMapNames(const std::vector<std::string>& runs);

/** The path of each run with scans in the frame of the site (comparison.RUN.tum), and the error
 *  along it for evo_res (comparison.RUN.evo.zip). */
void addTrajectories(const Comparison& comparison, FolderFiles& files);

/** Each run as a ROS map in the frame of the site (comparison.RUN.yaml and .pgm), its pose in that
 *  frame, and a session of the viewer "maps" with all of them.
 *  @throws DataError where a run cannot be read any more. */
void addSiteMaps(const Comparison& comparison, const ExtractOptions& options, FolderFiles& files);

/** For each break with a key frame: logs of the scans before and behind it, as the run has them and
 *  as they would lie without the break, and a scene of both. Numbered as in comparison.json, from
 *  1. Those whose run is not among `runs` are left out.
 *  @throws DataError where a run cannot be read any more. */
void addBreakFiles(const Comparison& comparison, const std::vector<Run>& runs,
                   const LoadGridOptions& reading, FolderFiles& files);

/** For each break of a run and each place that it has drawn twice logs of the scans on both sides,
 *  as the run has them and as they fit, beside its other results: `stem`.breakN.rawlog and so on,
 *  numbered as in its check.json, from 1. Of what has no size there is only the first.
 *  @throws DataError where the run cannot be read any more. */
void addCheckLogs(const RunCheck& check, const LoadGridOptions& reading, const std::string& stem,
                  FolderFiles& files);

/** Key frames by their numbers in the file, both included. */
struct KeyFrameStretch {
  std::size_t from = 0;
  std::optional<std::size_t> to;  ///< none for the last one
};

/** The bytes of a .rawlog of the scans of a simplemap.
 *  @throws DataError where the file is missing or damaged, or has no such key frames. */
std::string scanLog(const std::string& file, const LoadGridOptions& reading,
                    const KeyFrameStretch& stretch);

}  // namespace roomgraph
