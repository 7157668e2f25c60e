#include "roomgraph/evaluation/stability_progress.h"

#include <map>
#include <tuple>

#include "roomgraph/base/version.h"
#include "stability_json.h"

namespace roomgraph {
namespace {

std::optional<double> valueOf(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>());
}

Json json(const GraphDistance& d) {
  return {orNull(d.nearest), orNull(d.agreement.median), orNull(d.agreement.percentile90),
          orNull(d.agreement.unmatchedBase), orNull(d.agreement.unmatchedOther)};
}

GraphDistance distanceOf(const Json& json) {
  return {valueOf(json.at(0)),
          {valueOf(json.at(1)), valueOf(json.at(2)), valueOf(json.at(3)), valueOf(json.at(4))}};
}

Json json(const StabilityRun& run, const RunMeasures& measures) {
  return {{"distance", run.noise.maxDistance},
          {"percent", run.noise.percent},
          {"repeat", run.repeat},
          {"room", json(measures.room)},
          {"no_room", json(measures.noRoom)},
          {"rooms_found", orNull(measures.roomsFound)},
          {"rooms", measures.rooms}};
}

RunMeasures measuresOf(const Json& json) {
  return {distanceOf(json.at("room")), distanceOf(json.at("no_room")),
          valueOf(json.at("rooms_found")), json.at("rooms").get<int>()};
}

using RunName = std::tuple<int, double, int>;

std::map<RunName, RunMeasures> allMeasures(const Json& runs) {
  std::map<RunName, RunMeasures> all;
  for (const Json& run : runs)
    all[{run.at("distance").get<int>(), run.at("percent").get<double>(),
         run.at("repeat").get<int>()}] = measuresOf(run);
  return all;
}

}  // namespace

std::string stabilityKey(const GreyMap::Source& source, const ExtractOptions& extract,
                         const StabilityOptions& options) {
  return lineOf(Json{{"version", version()},
                     {"sha256", source.sha256},
                     {"options", optionsJson(extract)},
                     {"seed", options.seed},
                     {"base", {options.baseDistance, options.basePercent}},
                     {"match_within", options.matchWithin}});
}

std::string progressText(const std::string& key, const std::vector<StabilityRun>& runs,
                         const RunsDone& done) {
  std::string text = "{\n\"key\": " + key + ",\n\"runs\": [";
  const char* separator = "\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!done[i]) continue;
    text += separator + lineOf(json(runs[i], *done[i]));
    separator = ",\n";
  }
  return text + "\n]\n}\n";
}

RunsDone readProgress(const std::string& text, const std::string& key,
                      const std::vector<StabilityRun>& runs) {
  RunsDone done(runs.size());
  try {
    const Json file = Json::parse(text);
    if (lineOf(file.at("key")) != key) return done;
    const std::map<RunName, RunMeasures> known = allMeasures(file.at("runs"));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const auto found =
          known.find({runs[i].noise.maxDistance, runs[i].noise.percent, runs[i].repeat});
      if (found != known.end()) done[i] = found->second;
    }
  } catch (const Json::exception&) {
    return RunsDone(runs.size());  // damaged: everything is computed anew
  }
  return done;
}

}  // namespace roomgraph
