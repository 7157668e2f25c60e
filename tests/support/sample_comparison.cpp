#include "sample_comparison.h"

#include <cmath>

#include "roomgraph/align/wall_map.h"
#include "sampled_grid.h"

namespace roomgraph::test {
namespace {

struct Rect {
  double x0, y0, x1, y1;

  bool contains(Point p) const { return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1; }
};

constexpr Rect kFree[] = {{0.2, 0.2, 7.8, 4.8},   {8.2, 0.2, 15.8, 4.8}, {0.2, 7.2, 7.8, 11.8},
                          {8.2, 7.2, 15.8, 11.8}, {0.2, 5.2, 15.8, 6.8}, {3, 4.8, 4, 5.2},
                          {11, 4.8, 12, 5.2},     {3, 6.8, 4, 7.2},      {11, 6.8, 12, 7.2}};

/** Of the building, walls 0.4 m or more thick. */
State truthAt(Point p) {
  for (const Rect& rect : kFree)
    if (rect.contains(p)) return State::free;
  return Rect{0, 0, 16, 12}.contains(p) ? State::occupied : State::unknown;
}

/** The building as a run sees it from `pose` (run <- building). */
template <class Seen>
Run makeRun(const std::string& name, const Transform2D& pose, const Seen& seen) {
  const Transform2D back = pose.inverse();
  Run run;
  run.name = name, run.file = "runs/" + name + ".gridmap";
  run.sha256 = "0123456789abcdef of " + name;
  run.map = wallMap(
      sampledGrid({900, 900, 0.05, {-22.5, -22.5}}, [&](Point p) { return seen(back(p)); }));
  return run;
}

ComparedRun compared(const Run& run, const Transform2D& pose, std::size_t rank, double error) {
  ComparedRun result;
  result.name = run.name, result.file = run.file, result.pose = pose, result.rank = rank;
  RunScore score;
  score.mapError = error, score.errorLow = error / 2, score.errorHigh = 2 * error + 0.03;
  score.score = 100 * std::exp(-error / 0.5);
  score.low = 100 * std::exp(-score.errorHigh / 0.5);
  score.high = 100 * std::exp(-score.errorLow / 0.5);
  score.trust = 1 / double(rank);
  score.confirmed = 0.95, score.jitter = 0.06, score.scale = 1.002;
  score.support = 1000, score.others = 3, score.isMeaningful = rank < 4;
  result.score = score;
  result.measures = {{"coverage", 1.0 - 0.1 * double(rank), "1", 4000, 0.5, 0.9, true},
                     {"wall_distance", error / 3, "m", 900, error / 4, error / 2, rank < 4}};
  result.reason = "its walls lie near those of the 3 other runs";
  return result;
}

/** Along the corridor, with errors that grow to `error` [m]; the first cannot be told. */
std::vector<PathPose> pathThrough(double error) {
  std::vector<PathPose> path;
  for (std::size_t k = 0; k < 20; ++k)
    path.push_back({k,
                    1.5e9 + double(k) - 12,
                    {0.5 + 0.75 * double(k), 6, 0},
                    k > 0 ? std::optional(error * double(k) / 20) : std::nullopt});
  return path;
}

/** What a run that lies at `pose` (run <- site) sees along that way: both walls of the corridor. */
std::vector<ScanWalls> scansAlong(const std::vector<PathPose>& path, const Transform2D& pose) {
  std::vector<ScanWalls> scans;
  for (const PathPose& at : path) {
    ScanWalls scan;
    scan.keyFrame = at.keyFrame, scan.time = at.time, scan.pose = pose * at.pose;
    for (int i = -5; i <= 5; ++i)
      for (const double y : {5.2, 6.8})
        scan.walls.push_back({pose(Point{at.pose.x + 0.2 * i, y}), {}});
    scans.push_back(scan);
  }
  return scans;
}

SiteRoom room(const std::string& id, const Rect& r) {
  SiteRoom result;
  result.id = result.name = id;
  result.center = {(r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2};
  result.polygon.outer = {{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}};
  result.area = (r.x1 - r.x0) * (r.y1 - r.y0);
  return result;
}

std::vector<SiteRoom> rooms(const std::vector<Run>& runs) {
  std::vector<SiteRoom> result = {room("R1", kFree[0]), room("R2", kFree[1]), room("R3", kFree[2]),
                                  room("R4", kFree[3]), room("C1", kFree[4])};
  result[0].name = "Kitchen <b>&amp;</b>";
  result[4].isCorridor = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t k = 0; k < runs.size(); ++k) {
      RoomInRun one;
      one.run = runs[k].name, one.sighting = RoomSighting::seen, one.pieces = 1;
      one.shift = 0.05 * double(k + i), one.areaChange = 0.02 * double(k) - 0.03;
      one.boundaryAgreement = 0.98 - 0.1 * double(k);
      result[i].runs.push_back(one);
    }
  RoomInRun none;
  none.run = runs[2].name, none.sighting = RoomSighting::gone;
  result[2].runs[2] = none;
  none.run = runs[3].name, none.sighting = RoomSighting::unvisited;
  result[1].runs[3] = result[3].runs[3] = none;
  result[0].runs[1].pieces = 2, result[0].runs[2].isMerged = true;
  result[0].runs[2].doorsGained = 1, result[0].runs[3].doorsLost = 1;
  result[4].runs[0].lengthError = 0.12;
  return result;
}

ComparedPair pair(const std::string& a, const std::string& b, double confidence) {
  ComparedPair result;
  result.a = a, result.b = b, result.isSameSite = confidence > 0.5;
  result.transform = result.runnerUp = Transform2D{1, 2, 0.3};
  result.confidence = confidence, result.overlap = 0.8, result.runnerUpConfidence = 0.01;
  result.measures = {{"wall_distance", 0.11, "m", 900, {}, {}, true}};
  return result;
}

}  // namespace

const char* const kHostileName =
    "</script><script>window.struck=1</script><img src=x onerror=\"window.struck=1\">'\"&{{x}}";

SampleComparison sampleComparison() {
  const Transform2D poses[] = {{}, {3, -2, 0.5}, {-4, 1, 2.0}, {0, 5, -1.2}};
  const auto bent = [](Point p) {
    if (p.x >= 8) return truthAt({p.x - 0.3, p.y - 0.5});
    return p.y > 7 && truthAt(p) == State::free ? State::occupied : truthAt(p);
  };
  const auto west = [](Point p) { return p.x < 9 ? truthAt(p) : State::unknown; };
  SampleComparison sample;
  sample.runs = {makeRun("morning", poses[0], truthAt), makeRun("evening", poses[1], truthAt),
                 makeRun(kHostileName, poses[2], bent), makeRun("west", poses[3], west)};
  Comparison& c = sample.comparison;
  const double errors[] = {0.05, 0.11, 0.7, 1.2};
  for (std::size_t i = 0; i < 4; ++i)
    c.runs.push_back(compared(sample.runs[i], poses[i].inverse(), i + 1, errors[i]));
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b)
      c.pairs.push_back(pair(sample.runs[a].name, sample.runs[b].name, b == 3 ? 0.4 : 0.97));
  for (std::size_t i = 0; i < 3; ++i) c.runs[i].path = pathThrough(0.05 * double(i + 1));
  sample.runs[2].scans = scansAlong(c.runs[2].path, poses[2]);
  c.rooms = rooms(sample.runs);
  c.breaks = {
      {kHostileName, {8, 6}, 0.07, 0.58, 12, 1.5e9, TornPose{{8.3, 6.5, 0.17}, {8, 6, 0.1}}},
      {kHostileName, {12, 9}, -0.05, 0.3, {}, {}, {}}};
  c.leftOut = {{"garage", "garage.gridmap", "does not lie in the same site as the others", true}};
  c.verdict =
      "morning is the best map, with score 90.5 (78 to 95) and a map error of about 0.05 m.";
  c.options = {{"split_at_doors", "max_width", "1.5", "m", "How wide a door may be."}};
  return sample;
}

const SampleComparison& sample() {
  static const SampleComparison one = sampleComparison();
  return one;
}

}  // namespace roomgraph::test
