#include "sample_nights.h"

#include <cmath>

namespace roomgraph::test {

namespace {

constexpr double kDay = 86400;

}  // namespace

ComparedRun comparedRun(const std::string& name, double error, bool isMeaningful) {
  ComparedRun run;
  run.name = run.sha256 = name, run.file = name + ".simplemap";
  RunScore score;
  score.mapError = error, score.errorLow = error / 2, score.errorHigh = 2 * error;
  score.score = 100 * std::exp(-error / 0.5), score.support = 1000;
  score.isMeaningful = isMeaningful;
  run.score = score;
  run.measures = {{"coverage", 0.9, "1", 4000, 0.8, 1.0, true}};
  run.reason = "its walls lie where the others have them";
  return run;
}

SiteRoom squareRoom(const std::string& id, Point corner, const std::vector<std::string>& seenBy,
                    std::size_t doors) {
  SiteRoom room;
  room.id = room.name = id;
  room.center = {corner.x + 2, corner.y + 2}, room.area = 16;
  room.polygon.outer = {{corner.x, corner.y},
                        {corner.x + 4, corner.y},
                        {corner.x + 4, corner.y + 4},
                        {corner.x, corner.y + 4}};
  for (std::size_t i = 0; i < doors; ++i)
    room.doors.push_back({{corner.x + 2, corner.y + (i % 2 == 0 ? 0 : 4)}, 0.9, "", seenBy});
  for (const std::string& run : seenBy) {
    RoomInRun in;
    in.run = run, in.sighting = RoomSighting::seen, in.pieces = 1, in.areaChange = 0.01;
    room.runs.push_back(in);
  }
  return room;
}

Addition night(const std::string& site, const std::string& robot, int n, double error,
               const std::vector<std::string>& others, bool isMeaningful) {
  const std::string name = std::to_string(n);
  Addition addition;
  addition.site = site;
  addition.runs = {{name, robot, name + ".simplemap", n * kDay}};
  Comparison& comparison = addition.comparison;
  comparison.runs.push_back(comparedRun(name, error, isMeaningful));
  std::vector<std::string> all{name};
  for (const std::string& other : others) {
    comparison.runs.push_back(comparedRun(other, 0.1, isMeaningful));
    all.push_back(other);
  }
  comparison.rooms = {squareRoom("R1", {0, 0}, all), squareRoom("R2", {5, 0}, all),
                      squareRoom("R3", {0, 9}, all)};
  comparison.options = {{"find_rooms", "min_width", "2", "m", "A room is at least this wide."}};
  comparison.verdict = "the best is " + name;
  return addition;
}

HistoryRun historyRun(const std::string& robot, int n, double error) {
  HistoryRun run;
  run.sha256 = std::to_string(n) + robot, run.robot = robot, run.time = n * kDay;
  run.file = run.sha256 + ".simplemap", run.version = "1";
  Measure figure;
  figure.name = kMapError, figure.value = error, figure.unit = "m";
  figure.low = error / 2, figure.high = 2 * error;
  figure.support = 1000, figure.isMeaningful = true;
  run.figures.push_back(figure);
  return run;
}

}  // namespace roomgraph::test
