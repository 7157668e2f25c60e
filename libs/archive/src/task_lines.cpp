#include "roomgraph/archive/task_lines.h"

#include <sstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"

namespace roomgraph {
namespace {

FleetTask taskOf(const Json& json) {
  FleetTask task;
  task.site = json.at("site").get<std::string>();
  task.key = json.at("key").get<std::string>();
  task.newRuns = json.at("new").get<std::size_t>();
  for (const Json& run : json.at("runs"))
    task.runs.push_back({run.at("sha256").get<std::string>(), run.at("robot").get<std::string>(),
                         run.at("file").get<std::string>(), run.at("time").get<double>()});
  return task;
}

/** A key names a folder. */
bool isKey(const std::string& key) {
  return key.size() == 64 && key.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

std::string taskLines(const std::vector<FleetTask>& tasks) {
  std::string text;
  for (const FleetTask& task : tasks) {
    Json runs = Json::array();
    for (const HistoryRun& run : task.runs)
      runs.push_back(
          {{"sha256", run.sha256}, {"robot", run.robot}, {"file", run.file}, {"time", run.time}});
    const Json line = {
        {"site", task.site}, {"key", task.key}, {"new", task.newRuns}, {"runs", runs}};
    text += lineOf(line) + "\n";
  }
  return text;
}

std::vector<FleetTask> parseTaskLines(const std::string& text, const std::string& name) {
  std::vector<FleetTask> tasks;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::string where = name + ": line " + std::to_string(tasks.size() + 1);
    try {
      tasks.push_back(taskOf(Json::parse(line)));
    } catch (const nlohmann::json::exception&) {
      throw DataError(where + " is not a task: write the file anew with 'roomgraph plan'");
    }
    const FleetTask& task = tasks.back();
    if (!isKey(task.key) || task.runs.empty() || task.newRuns > task.runs.size())
      throw DataError(where + " is not a task: write the file anew with 'roomgraph plan'");
  }
  return tasks;
}

}  // namespace roomgraph
