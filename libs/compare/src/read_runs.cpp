#include <exception>
#include <functional>
#include <utility>

#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/failure_text.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/return_memory.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/compare/prepare_run.h"
#include "roomgraph/compare/run_names.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/relate/estimate_scale.h"

namespace roomgraph {
namespace {

/** A file on its way to a run. */
struct MapFile {
  std::string file, name;
  std::optional<GreyMap> picture;  ///< whose scale is not known yet
  std::optional<Run> run;
  Notes notes;                ///< on reading it
  std::string failure;        ///< why there is none; empty while there may be one
  bool isOtherSite = false;   ///< it could be read, but fits no other map
  std::exception_ptr misuse;  ///< what is no fault of the file

  LeftOutRun leftOut() const { return {name, file, failure, isOtherSite}; }
};

/** The text without the name of the file, which is told apart. */
std::string withoutFile(const std::string& text, const std::string& file) {
  return text.rfind(file + ": ", 0) == 0 ? text.substr(file.size() + 2) : text;
}

class Reader {
 public:
  Reader(std::vector<std::string> files, const CompareMapsOptions& options) : options_(options) {
    if (!options.reference.empty()) files.push_back(options.reference);
    const std::vector<std::string> names = runNames(files);
    for (std::size_t i = 0; i < files.size(); ++i) {
      files_.emplace_back();
      files_.back().file = files[i], files_.back().name = names[i];
    }
  }

  ReadRuns read() {
    forEachFile([this](MapFile& file) { open(file); });
    readPictures();
    ReadRuns result;
    result.runs = takeRuns();
    if (result.runs.empty()) refuseAll();
    if (hasReference()) result.reference = placeOfReference(result.runs);
    for (const MapFile& file : files_)
      if (!file.failure.empty()) result.leftOut.push_back(file.leftOut());
    sortBy(result.leftOut, &LeftOutRun::name);
    return result;
  }

 private:
  void forEachFile(const std::function<void(MapFile&)>& job) {
    std::vector<MapFile*> left;
    for (MapFile& file : files_)
      if (file.failure.empty() && !file.run) left.push_back(&file);
    options_.compare.forEach(left.size(), [&](std::size_t i) {
      MapFile& file = *left[i];
      try {
        job(file);
      } catch (const UsageError&) {
        file.misuse = std::current_exception();
      } catch (...) {
        file.failure = printable(withoutFile(failureText(file.file), file.file));
      }
      // Reading takes several times what a run keeps; of many, that would add up.
      returnMemory();
    });
    for (MapFile* file : left) {
      if (file->misuse) std::rethrow_exception(file->misuse);
      if (!file->failure.empty()) options_.onUnread(file->leftOut());
      for (const Note& note : std::exchange(file->notes, {})) options_.onNote(file->file, note);
    }
  }

  /** Who calls the library without a callback is told why, too. */
  [[noreturn]] void refuseAll() const {
    const std::string text = "no map could be used";
    for (const MapFile& file : files_)
      if (!file.failure.empty())
        throw DataError(text + " (" + file.file + ": " + file.failure + ")");
    throw DataError(text + ": give two or more");
  }

  void open(MapFile& file) const {
    LoadedMap read = loadMap(file.file, options_.extract.loadGrid);
    GreyMap& map = read.map;
    const bool isBare = map.source.kind == "image";
    const bool isGiven = options_.extract.loadGrid.isResolutionGiven;
    if (!isBare || (isGiven && !options_.estimatesScale)) {
      file.notes = map.notes;
      return prepare(file, map, read.keyframes);
    }
    if (bareWallMap(binarize(map, options_.extract.binarize)).walls.empty())
      throw DataError("has no wall beside free space: a run must have some");
    file.picture = std::move(map);
  }

  void prepare(MapFile& file, const GreyMap& map, const std::vector<Keyframe>& scans) const {
    file.run = prepareRun(file.name, map, scans, options_.extract);
    // Of many runs, most keep bare maps: all would not fit in memory.
    const bool isOneOfMany = &file - files_.data() >= 64;
    if (isOneOfMany && !options_.estimatesScale) dropLookUp(file.run->map);
  }

  /** Reads the bare pictures, whose scale is not known: where no map tells one, all at one that is
   *  usual; else at that at which they fit those maps, or as options say. */
  void readPictures() {
    if (options_.estimatesScale && !hasAny(&MapFile::picture) && !hasFailed())
      throw UsageError(
          "compare: --estimate-scale is for bare pictures, and no map is one: leave it out");
    if (!hasAny(&MapFile::picture)) return;
    const bool isEstimated = options_.estimatesScale || !hasAny(&MapFile::run);
    if (!hasAny(&MapFile::run))
      takeUsualScale();
    else if (options_.estimatesScale)
      fitScales();
    forEachFile([&](MapFile& file) {
      prepare(file, *file.picture, {});
      file.notes = std::move(file.picture->notes);
      file.run->isScaleEstimated = isEstimated;
      file.picture.reset();
    });
  }

  template <class Part>
  bool hasAny(std::optional<Part> MapFile::*part) const {
    return anyOf(files_, [&](const MapFile& file) { return (file.*part).has_value(); });
  }
  bool hasFailed() const {
    return anyOf(files_, [](const MapFile& file) { return !file.failure.empty(); });
  }

  static void setScale(GreyMap& picture, double resolution, const Notes& notes) {
    picture.frame = rescaled({picture.frame, {}}, resolution).frame;
    picture.notes = notes;
  }

  void takeUsualScale() {
    std::vector<Grid> grids;
    for (const MapFile& file : files_)
      if (file.picture) grids.push_back(binarize(*file.picture, options_.extract.binarize));
    const auto usual = usualScale(grids);
    if (!usual) return;
    const Note note{
        "usual_scale",
        formatted("no map tells the scale of the pictures: %.2g m per cell is taken, as "
                  "usual in buildings, so 1 m of error stands for %.0f cells",
                  *usual, 1 / *usual),
        std::nullopt};
    for (MapFile& file : files_)
      if (file.picture) setScale(*file.picture, *usual, {note});
  }

  void fitScales() {
    std::vector<Run> tellers = takeRunsOfKnownScale();
    for (MapFile& file : files_) {
      if (!file.picture) continue;
      const Grid grid = binarize(*file.picture, options_.extract.binarize);
      if (const auto found = estimateScale(grid, tellers, options_.compare.forEach))
        setScale(*file.picture, found->resolution, {});
      else
        refuse(file);
    }
    for (Run& run : tellers) giveBack(std::move(run));
  }

  /** Leaves a picture out that fits no scale. */
  void refuse(MapFile& file) const {
    file.isOtherSite = true;
    file.failure =
        "it fits the other maps at no scale: it is not of the same site, or shows too little";
    if (hasReference() && &file == &files_.back()) throw DataError(file.file + ": " + file.failure);
  }

  /** Those that tell the scale of the others: the reference, or else all. */
  std::vector<Run> takeRunsOfKnownScale() {
    if (!hasReference() || !files_.back().run) return takeRuns();
    std::vector<Run> runs;
    runs.push_back(*std::exchange(files_.back().run, std::nullopt));
    return runs;
  }

  /** All runs, sorted. Many of them, or large ones, would not fit in memory twice. */
  std::vector<Run> takeRuns() {
    std::vector<Run> runs;
    for (MapFile& file : files_)
      if (file.run) runs.push_back(*std::exchange(file.run, std::nullopt));
    sortRuns(runs);
    return runs;
  }

  void giveBack(Run run) {
    for (MapFile& file : files_)
      if (file.name == run.name) {
        file.run = std::move(run);
        return;
      }
  }

  bool hasReference() const { return !options_.reference.empty(); }

  std::size_t placeOfReference(const std::vector<Run>& runs) const {
    if (const Run* found = findRun(runs, files_.back().name))
      return std::size_t(found - runs.data());
    throw DataError(options_.reference + ": cannot be used as the reference: choose another one");
  }

  const CompareMapsOptions& options_;
  std::vector<MapFile> files_;
};

}  // namespace

ReadRuns readRuns(const std::vector<std::string>& files, const CompareMapsOptions& options) {
  if (options.compare.areAligned && options.estimatesScale)
    throw UsageError(
        "compare: aligned maps have a scale: set only one of compare.aligned and "
        "compare.estimate_scale");
  return Reader(files, options).read();
}

Run readRun(const std::string& file, CompareMapsOptions options) {
  options.onUnread = [](const LeftOutRun& run) { throw DataError(run.file + ": " + run.reason); };
  return readRuns({file}, options).runs.front();
}

}  // namespace roomgraph
