#include "roomgraph/archive/FleetTask.h"

#include <map>
#include <sstream>

#include "roomgraph/archive/plan_fleet.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** Takes out what is not as it was planned. */
void dropOthers(ReadRuns& read, const FleetTask& task, std::vector<std::string>& failures) {
  const std::string reason = "is another map now than when it was planned";
  std::map<std::string, std::string> planned;
  for (const HistoryRun& run : task.runs) planned[run.file] = run.sha256;
  const auto isOther = [&](const Run& run) { return planned[run.file] != run.sha256; };
  for (const Run& run : read.runs) {
    if (!isOther(run)) continue;
    read.leftOut.push_back({run.name, run.file, reason, false});
    failures.push_back(run.file + ": " + reason);
  }
  eraseIf(read.runs, isOther);
}

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

TaskResult doTask(const FleetTask& task, const CompareMapsOptions& options) {
  if (keyOf(task, options) != task.key)
    throw DataError("task of " + task.site +
                    ": was planned by another version or with other options: plan again");
  TaskResult result;
  CompareMapsOptions compare = options;
  compare.onUnread = [&](const LeftOutRun& run) {
    result.failures.push_back(run.file + ": " + run.reason);
  };
  ReadRuns read = readRuns(mapped(task.runs, &HistoryRun::file), compare);
  dropOthers(read, task, result.failures);
  if (read.runs.empty()) throw DataError("task of " + task.site + ": no map could be used");
  result.comparison = compareMaps(read, compare);
  return result;
}

std::string taskLines(const std::vector<FleetTask>& tasks) {
  std::string text;
  for (const FleetTask& task : tasks) {
    const Json runs = mapped(task.runs, [](const HistoryRun& run) {
      return Json{
          {"sha256", run.sha256}, {"robot", run.robot}, {"file", run.file}, {"time", run.time}};
    });
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
