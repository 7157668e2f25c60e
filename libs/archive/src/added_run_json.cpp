#include "roomgraph/archive/added_run_json.h"

#include "roomgraph/base/Json.h"

namespace roomgraph {
namespace {

Json lineJson(const std::string& file) {
  return {{"format", "roomgraph/watch"}, {"version", 1}, {"file", file}};
}

}  // namespace

std::string addedRunJson(const std::string& file, const AddedRun& run, const RobotWatch* robot) {
  const auto of = [&](double RunScore::*member) {
    return run.score ? numberOrNull((*run.score).*member) : Json(nullptr);
  };
  Json json = lineJson(file);
  json["error"] = nullptr;
  json["placed"] = run.isPlaced;
  json["map_error_m"] = of(&RunScore::mapError);
  json["map_error_low"] = of(&RunScore::errorLow);
  json["map_error_high"] = of(&RunScore::errorHigh);
  json["score"] = of(&RunScore::score);
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
