#include "archive_runs.h"

#include "roomgraph/archive/named_run.h"
#include "roomgraph/archive/record_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "terminal.h"

namespace roomgraph {

std::vector<std::string> recordFiles(const Archive& archive, const std::string& site,
                                     std::size_t most) {
  std::vector<std::string> files;
  const auto onMissing = [](const HistoryRun& run) {
    printError(run.file + ": note: is gone or another file now: left out");
  };
  for (const HistoryRun& run : recordRuns(archive.runs(site), most, onMissing))
    if (run.isPlaced) files.push_back(run.file);
  return files;
}

std::string fileOfRun(const Archive& archive, const std::string& site, const std::string& run,
                      const std::string& archiveFile) {
  const std::vector<HistoryRun> runs = archive.runs(site);
  const HistoryRun& meant = namedRun(runs, run, archiveFile);
  if (mapSha256(meant.file) != meant.sha256)
    throw DataError(meant.file + ": is another file now: 'archive add --keep' keeps copies");
  return meant.file;
}

}  // namespace roomgraph
