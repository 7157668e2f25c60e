// The functions that a program needs, as docs/library.md lists them: 04_library RUN RUN RUN writes
// all that there is of the first map, and of the comparison of all, into the current folder.
#include <roomgraph/roomgraph.h>

#include <cmath>
#include <cstdio>
#include <exception>

using namespace roomgraph;  // NOLINT: a program, not a library

namespace {

void writeGraph(const std::string& file) {
  ExtractOptions options = preset("default");
  options.keepClear.minClearance = 0.25;  // of a wider robot [m]
  const Stages stages = extract(loadGrid(file, options.loadGrid), options);
  for (const Passage& passage : stages.areas.passages)
    std::printf("%.2f m wide at (%.1f, %.1f)\n", passage.width, passage.middle().x,
                passage.middle().y);
  writeFileAtomically("graph.json", graphJson(stages));
  const GraphFile again = readGraphJson("graph.json");
  writeFileAtomically("graph.graphml", graphml(again.graph));
  writeFileAtomically("graph.geojson",
                      geojson(stages.result, ObstacleRows(stages.obstacles), stages.clearance));
  writeFileAtomically("graph.osm", osmXml(stages.areas));
  writeFileAtomically("graph.png", drawPng(stages));
  writeFileAtomically("graph.svg", drawSvg(stages));
}

/** What compareMaps reads, step by step, for maps that need not be files. */
std::vector<Run> prepareRuns(const std::vector<std::string>& files) {
  const ExtractOptions options;
  std::vector<Run> runs;
  for (const std::string& file : files) {
    const LoadedMap read = loadMap(file, options.loadGrid);
    runs.push_back(prepareRun(file, read.map, read.keyframes, options));
    runs.back().file = file;  // from which movedRun makes the mended one
  }
  return runs;
}

/** Each run by itself, and mended by the others; where the first scan lies on the second map. */
void mend(const std::vector<Run>& runs) {
  std::vector<MergedRun> merged;
  for (const RepairedRun& repaired : repairRuns(runs, {})) {
    const Run& run = runs[repaired.run];
    std::printf("%s %s\n", checkRun(run).sentence.c_str(), repaired.reason.c_str());
    writeFileAtomically("mended" + std::to_string(repaired.run) + ".simplemap.gz",
                        movedRun(run, repaired).simplemap);
    merged.push_back({run.name, loadMap(run.file, {}).keyframes, {}});
    for (std::size_t k = 0; k < repaired.poses.size(); ++k) {
      merged.back().drawn.push_back(merged.back().scans[k].pose);
      merged.back().scans[k].pose = repaired.frame.inverse() * repaired.poses[k];
    }
  }
  const MergedMap site = mergeRuns(merged, {}, oneByOne);
  std::printf("%d x %d cells\n", site.map.frame.width, site.map.frame.height);
  if (runs.size() < 2 || runs[0].scans.empty()) return;
  const Place start{"start", runs[0].scans[0].pose};
  for (const CarriedPlace& place : carryPlaces({start}, runs, 0, 1, {}))
    std::printf("%s lies at (%.2f, %.2f) on the other map\n", start.name.c_str(),
                place.pose ? place.pose->x : NAN, place.pose ? place.pose->y : NAN);
}

int writeComparison(const std::vector<std::string>& files) {
  writeFileAtomically("comparison.json", comparisonJson(compareMaps(files, {})));
  const Comparison comparison = readComparison("comparison.json");
  writeFileAtomically("report.html", comparisonReport(comparison, readMapsOf(comparison, files)));
  GateOptions gate;
  gate.maxError = 0.3, gate.failsOnBreaks = true;
  const GateVerdict verdict = gateVerdict(comparison, gate);
  for (const std::string& complaint : verdict.complaints) std::puts(complaint.c_str());
  return verdict.isPassed() ? 0 : 3;
}

}  // namespace

int main(int count, char** arguments) try {
  const std::vector<std::string> files(arguments + 1, arguments + count);
  if (files.empty()) return std::fprintf(stderr, "usage: 04_library RUN...\n"), 2;
  writeGraph(files.front());
  const std::vector<Run> runs = prepareRuns(files);
  std::puts(compareRuns(runs, {}).verdict.c_str());
  mend(runs);
  return writeComparison(files);
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
