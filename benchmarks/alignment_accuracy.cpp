// How often the alignment finds the true pose of one map in another, and what its confidence says.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "alignment_cases.h"
#include "cpu_seconds.h"
#include "cut_strip.h"
#include "roomgraph/align/align_maps.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "run_benchmark.h"

namespace roomgraph {
namespace {

struct Outcome {
  const AlignmentCase* what = nullptr;
  Alignment found;
  double angleError = 0;  ///< [deg]
  double placeError = 0;  ///< mean displacement [m]
  double seconds = 0;     ///< of CPU
  bool isRight = false;
  bool isRunnerUpRight = false;
};

struct PreparedMap {
  Grid grid;
  WallMap prepared;
};

/** Reads each map once. */
class Maps {
 public:
  explicit Maps(const std::vector<MapSource>& sources) : sources_(sources), maps_(sources.size()) {}

  const PreparedMap& at(std::size_t i) {
    if (!maps_[i]) {
      LoadGridOptions load;
      load.resolution = sources_[i].resolution;
      maps_[i] = std::make_unique<PreparedMap>();
      maps_[i]->grid = binarize(loadGrid(sources_[i].file, load), {});
      const double start = cpuSeconds();
      maps_[i]->prepared = wallMap(maps_[i]->grid);
      seconds_ += cpuSeconds() - start;
      ++count_;
    }
    return *maps_[i];
  }
  double secondsEach() const { return count_ ? seconds_ / count_ : 0; }

 private:
  const std::vector<MapSource>& sources_;
  std::vector<std::unique_ptr<PreparedMap>> maps_;
  double seconds_ = 0;
  int count_ = 0;
};

struct PoseError {
  double angle = 0, place = 0;
  bool isRight = false;
};

PoseError errorOf(const Transform2D& pose, const AlignmentCase& what,
                  const std::vector<Point>& places) {
  PoseError error;
  if (!what.truth) return error;
  error.angle = std::abs(wrappedAngle(pose.phi - what.truth->phi)) * 180 / M_PI;
  for (Point p : places) error.place += distance(pose(p), (*what.truth)(p)) / double(places.size());
  error.isRight = error.angle <= what.withinAngle && error.place <= what.within;
  return error;
}

Outcome run(const AlignmentCase& what, Maps& maps) {
  const PreparedMap &a = maps.at(what.a), &b = maps.at(what.b);
  std::vector<Point> places = what.places;
  WallMap cutA, cutB;
  Outcome outcome;
  outcome.what = &what;
  if (what.cut) {
    const CutPair pair = cutStrip(a.grid, b.grid, *what.truth, *what.cut);
    if (pair.places.empty()) return {};
    places = pair.places;
    cutA = wallMap(pair.a), cutB = wallMap(pair.b);
  } else if (places.empty()) {
    for (const WallPoint& wall : b.prepared.walls) places.push_back(wall.place);
  }
  const double start = cpuSeconds();
  outcome.found = alignMaps(what.cut ? cutA : a.prepared, what.cut ? cutB : b.prepared);
  outcome.seconds = cpuSeconds() - start;
  const PoseError error = errorOf(outcome.found.pose, what, places);
  outcome.angleError = error.angle, outcome.placeError = error.place;
  outcome.isRight = error.isRight;
  if (outcome.found.runnerUp)
    outcome.isRunnerUpRight = errorOf(outcome.found.runnerUp->pose, what, places).isRight;
  return outcome;
}

void printFeatures(FILE* file, const Outcome& o) {
  const auto print = [&](const std::optional<AlignmentCandidate>& c) {
    const AlignmentEvidence e = c ? c->evidence : AlignmentEvidence{};
    std::fprintf(file, ",%.4f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.4f,%.4f,%.3f,%.3f", c ? c->score : 0,
                 e.close, e.loose, e.contradicted, e.known, e.all, e.weakest, e.overlap,
                 e.freeOnWall, e.slightly, e.common);
  };
  std::fprintf(file, "%s,%s,%d,%.3f,%.3f", o.what->group.c_str(), o.what->name.c_str(),
               o.what->truth ? int(o.isRight) : -1, o.angleError, o.placeError);
  print(o.found.best);
  print(o.found.runnerUp);
  std::fprintf(file, ",%.4f\n", o.found.confidence);
}

void printGroup(const std::string& group, const std::vector<Outcome>& outcomes) {
  int all = 0, right = 0, within3 = 0, second = 0, same = 0, rightAndSame = 0;
  double seconds = 0, slowest = 0;
  for (const Outcome& o : outcomes) {
    if (o.what->group != group) continue;
    ++all;
    right += o.isRight;
    within3 += o.isRight && o.angleError <= 3;
    second += !o.isRight && o.isRunnerUpRight;
    same += o.found.isSameSite;
    rightAndSame += o.isRight && o.found.isSameSite;
    seconds += o.seconds, slowest = std::max(slowest, o.seconds);
  }
  std::printf("| %s | %d | %d (%.1f %%) | %d | %d | %d | %d | %.3f | %.3f |\n", group.c_str(), all,
              right, 100.0 * right / all, within3, second, same, rightAndSame, seconds / all,
              slowest);
}

/** Of the answers in each band of confidence, how many are right. */
void printCalibration(const std::vector<Outcome>& outcomes) {
  std::printf("\n| confidence | answers | mean confidence | right |\n|---|---|---|---|\n");
  const std::vector<double> bands = {0, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98, 1.0001};
  for (std::size_t i = 0; i + 1 < bands.size(); ++i) {
    int n = 0, right = 0;
    double sum = 0;
    for (const Outcome& o : outcomes)
      if (o.found.confidence >= bands[i] && o.found.confidence < bands[i + 1])
        ++n, right += o.isRight, sum += o.found.confidence;
    if (n)
      std::printf("| %.2f to %.2f | %d | %.3f | %.3f |\n", bands[i], std::min(1.0, bands[i + 1]), n,
                  sum / n, double(right) / n);
  }
}

void printWrong(const std::vector<Outcome>& outcomes) {
  std::printf("\nWrong or unsure:\n");
  for (const Outcome& o : outcomes) {
    const bool isWrong = o.what->truth ? !o.isRight || !o.found.isSameSite : o.found.isSameSite;
    if (!isWrong) continue;
    std::printf("%s: %s: confidence %.3f, off by %.1f deg and %.2f m%s%s\n", o.what->group.c_str(),
                o.what->name.c_str(), o.found.confidence, o.angleError, o.placeError,
                o.isRight ? " (right)" : "", o.isRunnerUpRight ? " (runner-up is right)" : "");
  }
}

AlignmentCases casesOf(const std::string& data, const std::string& only) {
  AlignmentCases cases;
  const auto wants = [&](const char* group) { return only.empty() || only == group; };
  if (wants("halmstad") || only == "strips") addHalmstad(data, cases);
  if (wants("sim") || only == "strips") addSimulated(data, cases);
  if (wants("strips")) addStrips(cases);
  if (only == "strips")
    cases.cases.erase(std::remove_if(cases.cases.begin(), cases.cases.end(),
                                     [](const AlignmentCase& c) { return !c.cut; }),
                      cases.cases.end());
  if (wants("strands")) addStrands(data, cases);
  if (wants("different")) addDifferent(data, cases);
  return cases;
}

void measure(const std::string& data, const std::string& only, const std::string& features,
             std::size_t every) {
  const AlignmentCases cases = casesOf(data, only);
  Maps maps(cases.sources);
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < cases.cases.size(); i += every) {
    Outcome outcome = run(cases.cases[i], maps);
    if (outcome.what) outcomes.push_back(std::move(outcome));
  }
  std::vector<std::string> groups;
  for (const Outcome& o : outcomes)
    if (std::find(groups.begin(), groups.end(), o.what->group) == groups.end())
      groups.push_back(o.what->group);
  std::printf(
      "| group | pairs | right | of these within 3 deg | runner-up right instead | \"same site\" | "
      "right and \"same site\" | CPU s a pair, mean | slowest "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& group : groups) printGroup(group, outcomes);
  std::printf("\nPreparing a map took %.3f CPU s on average.\n", maps.secondsEach());
  printCalibration(outcomes);
  printWrong(outcomes);
  if (features.empty()) return;
  const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(features.c_str(), "w"), std::fclose);
  if (!file) throw DataError(features + ": cannot be written");
  for (const Outcome& o : outcomes) printFeatures(file.get(), o);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("How often maps are aligned rightly, without a first guess.");
  std::string data, only, features;
  std::size_t every = 1;
  app.add_option("--data", data, "folder with multi_run, sim_runs, room_seg, ...")->required();
  app.add_option("--only", only, "halmstad, sim, strips, strands or different");
  app.add_option("--features", features, "file for what each confidence is made of, as csv");
  app.add_option("--every", every, "only every so manyth pair")->check(CLI::PositiveNumber);
  return roomgraph::runBenchmark(app, argc, argv,
                                 [&] { roomgraph::measure(data, only, features, every); });
}
