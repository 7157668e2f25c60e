#include "compare_maps.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "Command.h"
#include "PairFolder.h"
#include "error_line.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/ledger/name_rooms.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/relate/noise_floor.h"
#include "roomgraph/report/site_json.h"
#include "roomgraph/report/utf8_text.h"
#include "run_in_order.h"
#include "run_names.h"

namespace roomgraph {
namespace {

[[noreturn]] void refuseWithoutWalls(const std::string& file) {
  throw DataError(file + ": has no wall beside free space: a run must have some");
}

PreparedRun preparedRun(const std::string& name, const GreyMap& map,
                        const ExtractOptions& options) {
  const std::string& file = map.source.file;
  Stages stages = extract(map, options);
  PreparedRun run;
  run.name = name, run.file = utf8Text(file), run.sha256 = stages.source.sha256;
  run.map = mapForAlignment(stages.grid, {});
  if (run.map.walls.empty()) refuseWithoutWalls(file);
  run.noiseFloor = noiseFloor(stages.grid, run.map, {});
  run.rooms = std::move(stages.result.rooms);
  run.graph = std::move(stages.result.graph);
  run.areas = std::move(stages.areas);
  run.areas.labels = {};  // not needed any more
  run.resolution = map.frame.resolution;
  run.scans = scanWalls(loadKeyframes(file, options.loadGrid.maxDistanceInsertion));
  return run;
}

/** Nothing is known where there is no such file. */
SiteFile readSite(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  return parseSiteJson(readFile(file), file);
}

/** The part of an error line behind "roomgraph: FILE: ". */
std::string reasonIn(const std::string& line, const std::string& file) {
  const std::size_t at = line.find(printable(file) + ": ");
  std::string reason =
      at == std::string::npos ? line : line.substr(at + printable(file).size() + 2);
  while (!reason.empty() && reason.back() == '\n') reason.pop_back();
  return reason;
}

/** The maps on their way from files to a comparison. */
class Comparing {
 public:
  explicit Comparing(const CompareTask& task) : task_(task), files_(task.files) {
    if (!task.reference.empty()) files_.push_back(task.reference);
  }

  ComparedMaps run() {
    if (!task_.names.empty()) result_.site = readSite(task_.names);
    read();
    sortRuns(runs_);
    if (task_.estimatesScale) readPictures();
    if (runs_.empty())
      throw DataError("compare: no map could be used: nothing is written, earlier results stay");
    CompareRunsOptions options = task_.options;
    options.forEach = forEach();
    for (std::size_t i = 0; i < runs_.size(); ++i)
      if (!task_.reference.empty() && runs_[i].name == names_.back()) options.reference = i;
    if (!task_.reference.empty() && !options.reference)
      throw DataError(task_.reference + ": cannot be used as the reference: choose another one");
    relate();
    result_.comparison = compareRuns(runs_, related_, options);
    if (result_.site) nameRooms(result_.comparison.rooms, *result_.site, task_.names);
    addUnread();
    result_.runs = std::move(runs_);
    return std::move(result_);
  }

 private:
  void read() {
    names_ = runNames(files_);
    failures_.resize(files_.size());
    isOther_.resize(files_.size());
    pictures_.resize(files_.size());
    prepareAll([&](std::size_t i) -> std::optional<PreparedRun> {
      GreyMap map = loadGrid(files_[i], task_.extract.loadGrid);
      const bool isBare = map.source.kind == "image";
      if (!isBare || !task_.estimatesScale) return preparedRun(names_[i], map, task_.extract);
      if (wallsForAlignment(binarize(map, task_.extract.binarize), {}).walls.empty())
        refuseWithoutWalls(files_[i]);
      pictures_[i] = std::move(map);
      return std::nullopt;
    });
  }

  /** Adds the run that `prepared` makes of each file, if any. */
  void prepareAll(const std::function<std::optional<PreparedRun>(std::size_t)>& prepared) {
    std::vector<std::optional<PreparedRun>> runs(files_.size());
    JobList jobs;
    jobs.count = files_.size();
    jobs.run = [&](std::size_t i, const std::function<void()>& stepDone) {
      JobReport report;
      try {
        runs[i] = prepared(i);
      } catch (...) {
        const Failure failure = currentFailure(files_[i]);
        report.err = failures_[i] = failure.line;
        report.exitCode = failure.exitCode;
      }
      stepDone();
      return report;
    };
    result_.exitCode = std::max(result_.exitCode, runInOrder(jobs, task_.threads, !task_.isQuiet));
    for (auto& one : runs)
      if (one) runs_.push_back(std::move(*one));
  }

  bool isReference(std::size_t file) const {
    return !task_.reference.empty() && file + 1 == files_.size();
  }

  /** Reads the bare pictures at the scale at which they fit the other maps. */
  void readPictures() {
    checkScales();
    std::vector<PreparedRun> known;  // what tells the scale
    const auto reference = std::find_if(runs_.begin(), runs_.end(), [&](const PreparedRun& run) {
      return !task_.reference.empty() && run.name == names_.back();
    });
    if (reference != runs_.end()) known.push_back(*reference);
    const std::vector<PreparedRun>& tellers = known.empty() ? runs_ : known;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (!pictures_[i]) continue;
      GreyMap& picture = *pictures_[i];
      const Grid grid = binarize(picture, task_.extract.binarize);
      if (const auto found = estimateScale(grid, tellers, task_.scale, forEach()))
        picture.frame = rescaled({picture.frame, {}}, found->resolution).frame;
      else
        refuse(i);
    }
    prepareAll([&](std::size_t i) -> std::optional<PreparedRun> {
      if (!pictures_[i]) return std::nullopt;
      PreparedRun run = preparedRun(names_[i], *pictures_[i], task_.extract);
      run.isScaleEstimated = true;
      return run;
    });
    sortRuns(runs_);
  }

  void checkScales() const {
    const bool hasFailed = std::any_of(failures_.begin(), failures_.end(),
                                       [](const std::string& line) { return !line.empty(); });
    const bool hasPicture = std::any_of(pictures_.begin(), pictures_.end(),
                                        [](const auto& picture) { return picture.has_value(); });
    if (!hasPicture && !hasFailed)
      throw UsageError(
          "compare: --estimate-scale is for bare pictures, and no map is one: leave it out");
    if (hasPicture && runs_.empty())
      throw DataError(
          "compare: no map tells the scale of the pictures: add a gridmap, a simplemap or a yaml");
  }

  /** Leaves a picture out that fits no scale. */
  void refuse(std::size_t file) {
    pictures_[file].reset();
    isOther_[file] = true;
    failures_[file] =
        "it fits the other maps at no scale: it is not of the same site, or shows too little";
    if (isReference(file)) throw DataError(files_[file] + ": " + failures_[file]);
  }

  /** Does jobs on the threads that were asked for. */
  ForEach forEach() const {
    return [this](std::size_t count, const std::function<void(std::size_t)>& job) {
      JobList jobs;
      jobs.count = count;
      jobs.run = [&](std::size_t i, const std::function<void()>& stepDone) {
        job(i);
        stepDone();
        return JobReport();
      };
      runInOrder(jobs, task_.threads, !task_.isQuiet);
    };
  }

  void relate() {
    if (task_.cache.empty()) {
      related_ = relateRuns(runs_, task_.isAligned, forEach());
      return;
    }
    PairFolder folder(task_.cache);
    related_ = relateRuns(runs_, task_.isAligned, forEach(), folder.kept());
    if (!folder.failure().empty()) std::fputs(errorLine(folder.failure()).c_str(), stderr);
  }

  void addUnread() {
    std::vector<LeftOutRun>& out = result_.comparison.leftOut;
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (!failures_[i].empty())
        out.push_back({names_[i], files_[i], reasonIn(failures_[i], files_[i]), isOther_[i] != 0});
    std::sort(out.begin(), out.end(),
              [](const LeftOutRun& l, const LeftOutRun& r) { return l.name < r.name; });
  }

  const CompareTask& task_;
  std::vector<std::string> files_, names_, failures_;
  std::vector<char> isOther_;                     // files of another site
  std::vector<std::optional<GreyMap>> pictures_;  // by file, where the scale is to be estimated
  std::vector<PreparedRun> runs_;
  std::vector<MapPair> related_;
  ComparedMaps result_;
};

}  // namespace

ComparedMaps compareMaps(const CompareTask& task) { return Comparing(task).run(); }

}  // namespace roomgraph
