#include "roomgraph/archive/added_run_json.h"

#include "roomgraph/base/Json.h"

namespace roomgraph {
namespace {

Json lineJson(const std::string& file) {
  return {{"format", "roomgraph/watch"}, {"version", 1}, {"file", file}};
}

}  // namespace

std::string addedRunJson(const std::string& file, const AddedRun& run, const RobotWatch* robot) {
  const auto figure = [&](double RunScore::*member) {
    return run.score ? numberOrNull((*run.score).*member) : Json(nullptr);
  };
  Json json = lineJson(file);
  json["error"] = nullptr;
  json["placed"] = run.isPlaced;
  json["map_error_m"] = figure(&RunScore::mapError);
  json["map_error_low"] = figure(&RunScore::errorLow);
  json["map_error_high"] = figure(&RunScore::errorHigh);
  json["score"] = figure(&RunScore::score);
  json["meaningful"] = run.score && run.score->isMeaningful;
  json["reason"] = run.reason;
  json["alarm"] = robot && robot->errors.isAlarm();
  json["robot_says"] = robot ? Json(robot->sentence) : Json(nullptr);
  return lineOf(json);
}

std::string failedRunJson(const std::string& file, const std::string& error) {
  Json json = lineJson(file);
  json["error"] = error;
  return lineOf(json);
}

}  // namespace roomgraph
