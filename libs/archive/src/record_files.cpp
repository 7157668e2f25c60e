#include "roomgraph/archive/record_files.h"

#include <chrono>
#include <filesystem>

#include "roomgraph/archive/choose_record.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "roomgraph/map_files/read_recording.h"

namespace roomgraph {
namespace {

bool isThere(const KnownRun& run) {
  try {
    return mapSha256(run.file) == run.sha256;
  } catch (const DataError&) {
    return false;
  }
}

}  // namespace

std::vector<KnownRun> recordRuns(const std::vector<KnownRun>& runs, std::size_t most,
                                 const std::function<void(const KnownRun&)>& onMissing) {
  const auto isUsable = [&](const KnownRun& run) {
    const bool isUsed = isThere(run);
    if (!isUsed) onMissing(run);
    return isUsed;
  };
  std::vector<KnownRun> record;
  for (const std::size_t i : chooseRecord(runs, most, isUsable)) record.push_back(runs[i]);
  return record;
}

double runTime(const std::string& file) {
  namespace fs = std::filesystem;
  if (const auto recording = readRecording(file))
    if (const auto times = recording->times()) return times->first;
  // C++17 has no clock in common with that of files, so the distance to now is taken.
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file);
  const auto written = std::chrono::system_clock::now() -
                       std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
  return double(
      std::chrono::duration_cast<std::chrono::seconds>(written.time_since_epoch()).count());
}

}  // namespace roomgraph
