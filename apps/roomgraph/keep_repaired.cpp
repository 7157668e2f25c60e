#include "keep_repaired.h"

#include <algorithm>
#include <filesystem>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/repair/key_frame_moves.h"
#include "roomgraph/repair/repair_alone.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/scans/read_stored_poses.h"
#include "site_runs.h"

namespace roomgraph {
namespace {

std::string written(const Run& run, const RepairedRun& repaired) {
  if (repaired.state != RepairState::mended)
    return printable(run.file + ": " + repaired.reason) + "\n";
  CheckedFile file(run.file);
  const StoredPoses stored = readStoredPoses(file);
  const std::string content =
      movePoses(file.content(), file.name(), stored, keyFrameMoves(run, repaired, stored));
  const std::filesystem::path path(run.file);
  const std::string name = path.filename().string(), stem = mapStem(run.file);
  const std::string there =
      (path.parent_path() / (stem + ".repaired" + name.substr(std::min(stem.size(), name.size()))))
          .string();
  writeFileAtomically(there, compressed(content, file.compression()));
  return printable(there + ": " + repaired.reason) +
         formatted(", moved by up to %.2f m\n", repaired.movedMost);
}

}  // namespace

std::string keepRepaired(const std::string& kept, const std::vector<std::string>& record,
                         const ArchiveArguments& arguments) {
  if (record.empty()) {
    const Run run = readRun(kept, toCompareOptions(arguments.options));
    if (run.scans.empty()) return printable(kept) + ": has no scans: nothing can be mended\n";
    return written(run, repairAlone(run, checkRun(run)));
  }
  SiteArguments site;
  site.files = record;
  site.files.push_back(kept);
  site.cache = arguments.cache, site.options = arguments.options;
  site.running.threads = arguments.threads, site.running.isQuiet = arguments.isQuiet;
  const auto runs = solveRuns(site);
  for (const RepairedRun& one : repairRuns(runs->solved, rejoinPieces(runs->solved)))
    if (const Run& run = runs->read.runs[one.run]; run.file == kept) return written(run, one);
  return printable(kept) + ": has no scans, or fits no other run: nothing can be mended\n";
}

}  // namespace roomgraph
