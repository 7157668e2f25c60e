#include "roomgraph/archive/record_files.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/map_files/map_sha256.h"
#include "roomgraph/map_files/read_recording.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

void copy(const std::string& from, const fs::path& to) {
  writeFileAtomically(to.string(), readFile(from, std::numeric_limits<std::uint64_t>::max()));
}

/** Whether the file is there and holds what it should. */
bool holds(const std::string& file, const std::string& sha256) {
  return orNothing([&] { return mapSha256(file) == sha256; });
}

// Rooms change over years, so the best of all times is no judge; nor are the files of years asked
// for.
constexpr std::size_t kLast = 100;

}  // namespace

std::vector<HistoryRun> recordRuns(const std::vector<HistoryRun>& runs, std::size_t most,
                                   const std::function<void(const HistoryRun&)>& onMissing) {
  const auto isUsable = [&](const HistoryRun& run) {
    const bool isUsed = holds(run.file, run.sha256);
    if (!isUsed) onMissing(run);
    return isUsed;
  };
  return mapped(chooseRecord(runs, most, isUsable), [&](std::size_t i) { return runs[i]; });
}

double runTime(const std::string& file) {
  if (const auto recording = readRecording(file))
    if (const auto times = recording->times()) return times->first;
  // C++17 has no clock in common with that of files, so the distance to now is taken.
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file);
  const auto written = std::chrono::system_clock::now() -
                       std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
  return double(
      std::chrono::duration_cast<std::chrono::seconds>(written.time_since_epoch()).count());
}

std::string keepMap(const std::string& file, const std::string& sha256, const std::string& folder) {
  const fs::path home = fs::absolute(folder).lexically_normal() / sha256.substr(0, 16);
  std::string kept = (home / fs::path(file).filename()).string();
  if (holds(kept, sha256)) return kept;
  makeWritableFolder(folder);
  makeWritableFolder(home.string());
  if (const std::string picture = pictureOfMap(file); !picture.empty()) {
    const fs::path place = fs::path(picture).lexically_relative(fs::path(file).parent_path());
    if (place.empty() || place.has_parent_path())
      refuse(file, "names a picture in another folder, " + picture, "keep both in one folder");
    copy(picture, home / place);
  }
  copy(file, kept);
  if (!holds(kept, sha256)) refuse(file, "was changed while it was added", "add it again");
  return kept;
}

std::vector<std::size_t> chooseRecord(const std::vector<HistoryRun>& runs, std::size_t most,
                                      const std::function<bool(const HistoryRun&)>& isUsable) {
  std::vector<std::size_t> latest, best, elsewhere;
  std::size_t since = 0;
  for (std::size_t i = runs.size(); i-- > 0 && latest.size() < kLast;) {
    (runs[i].isPlaced ? latest : elsewhere).push_back(i);
    if (latest.empty()) ++since;
  }
  if (elsewhere.size() < latest.size()) elsewhere.resize(since);
  for (const std::size_t i : latest)
    if (trustedValueOf(runs[i].figures, kMapError) &&
        valueOf(runs[i].figures, kBreaks).value_or(0) == 0)
      best.push_back(i);
  sortBy(best, [&](std::size_t i) { return *trustedValueOf(runs[i].figures, kMapError); });
  std::vector<std::size_t> chosen;
  std::vector<bool> isAsked(runs.size());
  const auto fill = [&](const std::vector<std::size_t>& candidates, std::size_t upTo) {
    for (const std::size_t i : candidates) {
      if (chosen.size() >= upTo) return;
      if (!isAsked[i] && isUsable(runs[i])) chosen.push_back(i);
      isAsked[i] = true;
    }
  };
  fill(elsewhere, (most + 2) / 3);
  fill(latest, (chosen.size() + most) / 2);
  fill(best, most);
  fill(latest, most);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace roomgraph
