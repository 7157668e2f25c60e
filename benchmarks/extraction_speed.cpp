// How much the whole extraction costs beside the bare Voronoi diagram of the same obstacles.
#include <errno.h>
#include <unistd.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "FloorPlan.h"
#include "cpu_seconds.h"
#include "make_office.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"
#include "run_benchmark.h"
#include "write_map.h"

namespace roomgraph {
namespace {

constexpr double kMostRatio = 2.0, kMostRatioWithAreas = 2.5, kMostExponent = 1.1;
constexpr double kBytesPerSite = 600, kBytesPerCell = 3;

/** A map to measure: a file, or an artificial office where `file` is empty. */
struct Case {
  std::string name, file;
  int officeSize = 0;  ///< cells each way
};

/** What one extraction takes in a process of its own. */
struct OwnProcess {
  double bytes = 0;  ///< peak, beyond that of a map of 8 x 8 cells
  double obstacles = 0, cells = 0;
  double seconds = 0;  ///< of CPU, map in memory to areas

  double perObstacle() const { return (bytes - kBytesPerCell * cells) / obstacles; }
};

/** CPU time of one extraction from the obstacles on [s]. */
struct Whole {
  double toGraph = 0, withAreas = 0;
};

struct Times {
  std::vector<double> bare;  ///< [s of CPU], in the order of the repeats
  std::vector<Whole> whole;

  double median(double Whole::*part) const {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < bare.size(); ++i) ratios.push_back(whole[i].*part / bare[i]);
    std::nth_element(ratios.begin(), ratios.begin() + std::ptrdiff_t(ratios.size() / 2),
                     ratios.end());
    return ratios[ratios.size() / 2];
  }
  double fastest(double Whole::*part) const {
    double least = whole.front().*part;
    for (const Whole& one : whole) least = std::min(least, one.*part);
    return least;
  }
};

std::vector<Case> allCases(int largest) {
  const std::string mrpt = "/usr/share/mrpt/datasets/";
  std::vector<Case> cases = {{"uwb", mrpt + "uwb_ro-localization_demo_map.gridmap.gz"},
                             {"Malaga campus", mrpt + "2006-MalagaCampus.gridmap.gz"}};
  for (int size = 1000; size <= largest; size *= 2)
    cases.push_back({"office " + std::to_string(size) + "²", "", size});
  return cases;
}

GreyMap load(const Case& which) {
  if (!which.file.empty()) return loadGrid(which.file, {});
  MakeOfficeOptions office;
  office.width = office.height = which.officeSize;
  return makeOffice(office);
}

/** Shares the CPU time of an extraction out by the steps' own clocks. */
Whole timesAfterSites(const Stages& stages, double seconds) {
  const std::set<std::string> beforeDiagram{"binarize", "obstacle_cells"};
  double all = 0, before = 0, areas = 0;
  for (const StageTiming& timing : stages.timings) {
    all += timing.seconds;
    if (beforeDiagram.count(timing.stage)) before += timing.seconds;
    if (timing.stage == "area_graph") areas += timing.seconds;
  }
  return {seconds * (all - before - areas) / all, seconds * (all - before) / all};
}

Whole timeWhole(const GreyMap& map, std::vector<boost::polygon::point_data<int>>& obstacles) {
  const double start = cpuSeconds();
  const Stages stages = extract(map, {});
  const double seconds = cpuSeconds() - start;
  obstacles.clear();
  for (const Cell cell : stages.obstacles.cells) obstacles.emplace_back(cell.x, cell.y);
  return timesAfterSites(stages, seconds);
}

double timeBare(const std::vector<boost::polygon::point_data<int>>& obstacles) {
  boost::polygon::voronoi_diagram<double> diagram;
  const double start = cpuSeconds();
  boost::polygon::construct_voronoi(obstacles.begin(), obstacles.end(), &diagram);
  return cpuSeconds() - start;
}

/** In turns, so that what slows the machine down slows both; at least 5 times, up to 3 s. */
Times measureTimes(const Case& which) {
  const GreyMap map = load(which);
  std::vector<boost::polygon::point_data<int>> obstacles;
  Times times;
  timeWhole(map, obstacles);  // warms up, and finds the obstacles
  double spent = 0;
  while (times.bare.size() < 5 || (spent < 3 && times.bare.size() < 51)) {
    times.bare.push_back(timeBare(obstacles));
    times.whole.push_back(timeWhole(map, obstacles));
    spent += times.bare.back() + times.whole.back().withAreas;
  }
  return times;
}

/** Peak of the resident memory so far [bytes]. Of this program only: getrusage also counts what the
 *  process was before it became this program. */
double peakBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return 1024 * kilobytes;
  }
  throw DataError("/proc/self/status: has no VmHWM; this needs Linux");
}

/** Reads and extracts a map of 8 x 8 cells: the code and the tables that any map needs are then in
 *  memory, MRPT's start among them. */
void warmUp() {
  const auto file = std::filesystem::temp_directory_path() /
                    ("roomgraph_speed_" + std::to_string(getpid()) + ".gridmap.gz");
  FloorPlan plan(8, 8, 0.05);
  plan.fill({0, 0, 8, 8}, grey::kWall);
  plan.fill({1, 1, 7, 7}, grey::kFree);
  writeGridmap(plan.map(), file);
  const GreyMap map = loadGrid(file, {});
  std::filesystem::remove(file);
  (void)extract(map, {});
}

/** What a child process does: one extraction, then how much memory and time it took. */
void printOwnProcess(const Case& which) {
  warmUp();
  const double startBytes = peakBytes();
  const GreyMap map = load(which);
  const double start = cpuSeconds();
  const Stages stages = extract(map, {});
  const double seconds = cpuSeconds() - start;
  std::printf("%.0f %zu %zu %.6f\n", peakBytes() - startBytes, stages.obstacles.cells.size(),
              map.grey.size(), seconds);
}

OwnProcess runOwnProcess(const Case& which, int largest) {
  const std::string command = "exec '" + std::string(program_invocation_name) + "' --largest " +
                              std::to_string(largest) + " --one '" + which.name + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> child(popen(command.c_str(), "r"), pclose);
  OwnProcess own;
  if (!child || std::fscanf(child.get(), "%lf %lf %lf %lf", &own.bytes, &own.obstacles, &own.cells,
                            &own.seconds) != 4)
    throw DataError(which.name + ": the run in a process of its own failed");
  return own;
}

/** The most memory and the least time of three processes. */
OwnProcess measureOwnProcess(const Case& which, int largest) {
  OwnProcess own = runOwnProcess(which, largest);
  for (int i = 1; i < 3; ++i) {
    const OwnProcess again = runOwnProcess(which, largest);
    own.bytes = std::max(own.bytes, again.bytes);
    own.seconds = std::min(own.seconds, again.seconds);
  }
  return own;
}

/** Slope of the line through (log x, log y). */
double exponent(const std::vector<double>& xs, const std::vector<double>& ys) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double n = double(xs.size());
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double x = std::log(xs[i]), y = std::log(ys[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

const char* verdict(bool isWithin) { return isWithin ? "PASS" : "**over**"; }

void printHeader() {
  std::printf(
      "| map | cells | obstacles | time to the graph | <= %.1f | with areas | <= %.1f | "
      "bytes per obstacle beyond %.0f per cell | <= %.0f |\n"
      "|---|---|---|---|---|---|---|---|---|\n",
      kMostRatio, kMostRatioWithAreas, kBytesPerCell, kBytesPerSite);
}

/** How the times grow over the offices. A process that extracts many maps gives small maps warm
 *  memory and large ones new pages each time; one map in a process of its own is what users run. */
struct Growth {
  std::vector<double> obstacles, own, whole, bare;

  bool isWithin() const {
    return obstacles.size() < 2 || exponent(obstacles, own) <= kMostExponent;
  }
  void print() const {
    if (obstacles.size() < 2) return;
    std::printf(
        "\nOver the offices, time grows with obstacles^%.2f, each map in a process of its own "
        "(at most %.1f: %s); in turns within one process with obstacles^%.2f, and the bare diagram "
        "there with obstacles^%.2f.\n",
        exponent(obstacles, own), kMostExponent, verdict(isWithin()), exponent(obstacles, whole),
        exponent(obstacles, bare));
  }
};

bool measureAll(int largest) {
  printHeader();
  bool isAllWithin = true;
  Growth growth;
  for (const Case& which : allCases(largest)) {
    const OwnProcess own = measureOwnProcess(which, largest);
    const Times times = measureTimes(which);
    const double toGraph = times.median(&Whole::toGraph), all = times.median(&Whole::withAreas);
    const bool isFast = toGraph <= kMostRatio, isFastWithAreas = all <= kMostRatioWithAreas;
    const bool isSmall = own.perObstacle() <= kBytesPerSite;
    std::printf("| %s | %.0f | %.0f | %.2f | %s | %.2f | %s | %.0f | %s |\n", which.name.c_str(),
                own.cells, own.obstacles, toGraph, verdict(isFast), all, verdict(isFastWithAreas),
                own.perObstacle(), verdict(isSmall));
    std::fflush(stdout);
    isAllWithin = isAllWithin && isFast && isFastWithAreas && isSmall;
    if (!which.file.empty()) continue;
    growth.obstacles.push_back(own.obstacles);
    growth.own.push_back(own.seconds);
    growth.bare.push_back(*std::min_element(times.bare.begin(), times.bare.end()));
    growth.whole.push_back(times.fastest(&Whole::withAreas));
  }
  growth.print();
  return isAllWithin && growth.isWithin();
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("CPU time and memory of the extraction, as ratios to the bare Voronoi diagram.");
  int largest = 8000;
  std::string one;
  app.add_option("--largest", largest, "largest office [cells each way]: 1000, 2000, 4000 or 8000")
      ->capture_default_str();
  app.add_option(
      "--one", one,
      "only extract this one map; print the bytes it took, its obstacles, cells and seconds");
  return roomgraph::runBenchmark(app, argc, argv, [&] {
    if (one.empty()) return roomgraph::measureAll(largest);
    for (const roomgraph::Case& which : roomgraph::allCases(largest))
      if (which.name == one) return roomgraph::printOwnProcess(which), true;
    throw roomgraph::UsageError("there is no map '" + one + "'");
  });
}
