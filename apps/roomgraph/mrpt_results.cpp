#include "mrpt_results.h"

#include <algorithm>
#include <map>

#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/read_recording.h"
#include "roomgraph/mrpt_plugin/break_files.h"
#include "roomgraph/mrpt_plugin/rawlog_file.h"
#include "roomgraph/scans/place_scans.h"

namespace roomgraph {
namespace {

std::vector<PlacedScan> scansOf(const std::string& file, const LoadGridOptions& reading) {
  auto recording = readRecording(file);
  if (!recording) return {};
  return placeScans(std::move(*recording), reading).scans;
}

}  // namespace

std::vector<std::string> addBreakFiles(const Comparison& comparison, const std::vector<Run>& runs,
                                       const LoadGridOptions& reading,
                                       const std::filesystem::path& folder, StagedFiles& staged) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const std::string& bytes) {
    names.push_back((folder / name).string());
    staged.add(names.back(), bytes);
  };
  std::map<std::string, std::vector<PlacedScan>> read;  // by run
  for (std::size_t i = 0; i < comparison.breaks.size(); ++i) {
    const MapBreak& tear = comparison.breaks[i];
    const auto isTorn = [&](const auto& run) { return run.name == tear.run; };
    const auto run = std::find_if(runs.begin(), runs.end(), isTorn);
    const auto placed = std::find_if(comparison.runs.begin(), comparison.runs.end(), isTorn);
    if (!tear.keyFrame || run == runs.end() || placed == comparison.runs.end()) continue;
    const auto [known, isNew] = read.try_emplace(tear.run);
    if (isNew) known->second = scansOf(run->file, reading);
    const std::vector<PlacedScan>& scans = known->second;
    const std::string stem = "comparison.break" + std::to_string(i + 1);
    for (const bool isUntorn : {false, true})
      add(stem + (isUntorn ? ".untorn.rawlog" : ".rawlog"),
          rawlogBytes(scansAtBreak(tear, placed->pose, scans, isUntorn)));
    add(stem + ".3Dscene", breakSceneBytes(comparison, tear, runs));
  }
  return names;
}

void addCheckLogs(const RunCheck& check, const LoadGridOptions& reading, const std::string& stem,
                  StagedFiles& staged) {
  if (check.breaks.empty() && check.doubled.empty()) return;
  const std::vector<PlacedScan> scans = scansOf(check.file, reading);
  const auto add = [&](const char* kind, std::size_t number, const auto& scansAt, bool hasFit) {
    const std::string name = stem + "." + kind + std::to_string(number);
    staged.add(name + ".rawlog", rawlogBytes(scansAt(false)));
    if (hasFit) staged.add(name + ".untorn.rawlog", rawlogBytes(scansAt(true)));
  };
  for (std::size_t i = 0; i < check.breaks.size(); ++i) {
    const MapBreak& tear = check.breaks[i];
    const auto at = [&](bool isUntorn) { return scansAtBreak(tear, {}, scans, isUntorn); };
    add("break", i + 1, at, tear.torn.has_value());
  }
  for (std::size_t i = 0; i < check.doubled.size(); ++i) {
    const auto at = [&](bool isUntorn) {
      return scansAtDoubled(check.doubled[i], scans, isUntorn);
    };
    add("doubled", i + 1, at, true);
  }
}

std::string scanLog(const std::string& file, const LoadGridOptions& reading,
                    const KeyFrameStretch& stretch) {
  std::vector<PlacedScan> scans = scansOf(file, reading);
  if (scans.empty()) throw DataError(file + ": has no key frames: give a simplemap with scans");
  const std::size_t last = scans.back().keyFrame, to = stretch.to.value_or(last);
  if (std::max(stretch.from, to) > last)
    throw DataError(file + ": its last key frame is " + std::to_string(last) +
                    ": choose --from and --to up to that");
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                             [&](const PlacedScan& scan) {
                               return scan.keyFrame < stretch.from || scan.keyFrame > to;
                             }),
              scans.end());
  return rawlogBytes(scans);
}

}  // namespace roomgraph
