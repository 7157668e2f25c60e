#include "roomgraph/report/comparison_json.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/file_name.h"
#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/report/json_parts.h"

namespace roomgraph {
namespace {

Json poseJson(const Transform2D& pose) {
  return {rounded(pose.x), rounded(pose.y), std::round(pose.phi * 1e6) / 1e6 + 0.0};
}

Json poseJson(const std::optional<Transform2D>& pose) {
  return pose ? poseJson(*pose) : Json(nullptr);
}

Json measureJson(const Measure& measure) {
  Json json{{"value", numberOrNull(measure.value)},   {"unit", measure.unit},
            {"support", std::round(measure.support)}, {"low", numberOrNull(measure.low)},
            {"high", numberOrNull(measure.high)},     {"meaningful", measure.isMeaningful}};
  if (measure.place) json["x"] = rounded(measure.place->x), json["y"] = rounded(measure.place->y);
  return json;
}

Json pathPoseJson(const PathPose& at) {
  return {{"key_frame", at.keyFrame},    {"time", orNull(at.time)},
          {"x", rounded(at.pose.x)},     {"y", rounded(at.pose.y)},
          {"phi", rounded(at.pose.phi)}, {"error_m", numberOrNull(at.error)}};
}

Json runJson(const ComparedRun& run, const Comparison& comparison) {
  const auto figure = [&](double RunScore::*member) {
    return run.score ? numberOrNull((*run.score).*member) : Json(nullptr);
  };
  Json json = {{"name", run.name},
               {"file", fileName(run.file)},
               {"sha256", run.sha256},
               {"score", figure(&RunScore::score)},
               {"score_low", figure(&RunScore::low)},
               {"score_high", figure(&RunScore::high)},
               {"map_error_m", figure(&RunScore::mapError)},
               {"map_error_low", figure(&RunScore::errorLow)},
               {"map_error_high", figure(&RunScore::errorHigh)},
               {"meaningful", run.score && run.score->isMeaningful},
               {"certainty", nameOf(comparison.certaintyOf(run))},
               {"rank", run.rank ? Json(run.rank) : Json(nullptr)},
               {"reason", run.reason},
               {"shared_walls", figure(&RunScore::share)},
               {"compared_walls", figure(&RunScore::support)},
               {"others", run.score ? Json(run.score->others) : Json(nullptr)},
               {"trust", figure(&RunScore::trust)},
               {"confirmed", figure(&RunScore::confirmed)},
               {"contradicted", figure(&RunScore::contradicted)},
               {"jitter_m", figure(&RunScore::jitter)},
               {"scale", figure(&RunScore::scale)},
               {"scale_disputed", run.score && run.score->isScaleDisputed},
               {"pose", poseJson(run.pose)},
               {"resolution", std::round(run.resolution * 1e6) / 1e6},
               {"scale_estimated", run.isScaleEstimated},
               {"measures", measuresJson(run.measures)},
               {"path", mapped(run.path, pathPoseJson)}};
  if (run.welded) json["welded"] = {run.welded->first, run.welded->second};
  if (run.score && run.score->givenUp > 0) json["given_up"] = rounded(run.score->givenUp);
  if (!run.relativePath.empty()) json["relative_path"] = run.relativePath;
  return json;
}

Json pairJson(const ComparedPair& pair) {
  Json runnerUp = nullptr;
  if (pair.runnerUp)
    runnerUp = {{"transform", poseJson(*pair.runnerUp)},
                {"confidence", numberOrNull(pair.runnerUpConfidence)}};
  Json json = {{"a", pair.a},
               {"b", pair.b},
               {"same_site", pair.isSameSite},
               {"transform", poseJson(pair.transform)},
               {"confidence", numberOrNull(pair.confidence)},
               {"overlap", numberOrNull(pair.overlap)},
               {"runner_up", runnerUp},
               {"measures", measuresJson(pair.measures)}};
  if (pair.areCopies || pair.areEdits) json["one_picture"] = pair.areCopies ? "copies" : "edits";
  return json;
}

Json breakJson(const MapBreak& tear) {
  const std::optional<TornPose>& torn = tear.torn;
  return {{"run", tear.run},
          {"x", rounded(tear.place.x)},
          {"y", rounded(tear.place.y)},
          {"rotation_deg", rounded(tear.rotation * 180 / M_PI)},
          {"shift_m", rounded(tear.shift)},
          {"class", nameOf(tear.kind())},
          {"key_frame", orNull(tear.keyFrame)},
          {"time", orNull(tear.time)},
          {"pose_drawn", torn ? poseJson(torn->drawn) : Json()},
          {"pose_untorn", torn ? poseJson(torn->untorn) : Json()}};
}

Json roomInRunJson(const RoomInRun& in) {
  return {{"run", in.run},
          {"sighting", nameOf(in.sighting)},
          {"pieces", in.pieces},
          {"merged", in.isMerged},
          {"shift_m", numberOrNull(in.shift)},
          {"area_change", numberOrNull(in.areaChange)},
          {"boundary_agreement", numberOrNull(in.boundaryAgreement)},
          {"length_error_m", numberOrNull(in.lengthError)},
          {"doors_gained", in.doorsGained},
          {"doors_lost", in.doorsLost}};
}

Json doorWithRunsJson(const SiteDoor& door) {
  Json json = doorJson(door);
  json["seen_in"] = door.seenIn, json["lost_in"] = door.lostIn;
  return json;
}

Json roomJson(const SiteRoom& room) {
  Json json = placedRoomJson(room, mapped(room.doors, doorWithRunsJson));
  json["runs"] = mapped(room.runs, roomInRunJson);
  return json;
}

/** Sections of keys, as in the file of a graph: numbers and switches as such. */
Json optionsJson(const std::vector<UsedOption>& options) {
  Json json = Json::object();
  for (const UsedOption& option : options) {
    const Json value = Json::parse(option.value, nullptr, false);
    json[option.section][option.name] =
        value.is_number() || value.is_boolean() ? value : Json(option.value);
  }
  return json;
}

Json gateJson(const std::optional<GateVerdict>& gate) {
  if (!gate) return nullptr;
  return {{"passed", gate->isPassed()},
          {"complaints", gate->complaints},
          {"candidates", gate->candidates},
          {"asked", gate->asked},
          {"margins", gate->margins}};
}

/** What comparisonText says of a run that has a score. */
std::string scoreText(const RunScore& score, const std::string& coverage,
                      const std::string& certainty) {
  return formatted("  %5.1f %6.1f-%5.1f  %13.3f  %6.3f-%6.3f  %8s%s\n", score.score, score.low,
                   score.high, score.mapError, score.errorLow, score.errorHigh, coverage.c_str(),
                   certainty.c_str());
}

}  // namespace

Json measuresJson(const std::vector<Measure>& measures) {
  Json json = Json::object();
  for (const Measure& measure : measures) json[measure.name] = measureJson(measure);
  return json;
}

std::string comparisonJson(const Comparison& comparison) {
  JsonDocument document("roomgraph/comparison");
  document.add("reference", orNull(comparison.reference));
  if (comparison.referenceDoubled > 0)
    document.add("reference_doubled_m", rounded(comparison.referenceDoubled));
  if (!comparison.core.empty()) document.add("core", comparison.core);
  if (comparison.isOneDrive) document.add("one_drive", true);
  document.addList("runs", comparison.runs,
                   [&](const ComparedRun& run) { return runJson(run, comparison); });
  document.addList("pairs", comparison.pairs, pairJson);
  document.addList("left_out", comparison.leftOut, [](const LeftOutRun& run) {
    return Json{{"name", run.name},
                {"file", fileName(run.file)},
                {"reason", run.reason},
                {"other_site", run.isOtherSite}};
  });
  document.addList("rooms", comparison.rooms, roomJson);
  document.addList("breaks", comparison.breaks, breakJson);
  document.add("options", optionsJson(comparison.options));
  document.add("gate", gateJson(comparison.gate));
  document.add("files", comparison.files);
  document.add("verdict", comparison.verdict);
  return std::move(document).text();
}

std::string comparisonText(const Comparison& comparison) {
  std::size_t width = 3;
  for (const ComparedRun& run : comparison.runs)
    width = std::max(width, printable(run.name).size());
  std::string text = "rank  run" + std::string(width - 3, ' ') +
                     "  score         (80 %)  map error [m]          (80 %)  coverage  certainty\n";
  for (const ComparedRun& run : comparison.runs) {
    const double seen = rounded(valueOf(run.measures, "coverage").value_or(-1));
    std::string name = printable(run.name);
    name.resize(width, ' ');
    const std::string share = seen >= 0 ? formatted("%.0f %%", 100 * seen) : "-";
    const std::string certainty =
        std::string("  ") +
        (run.name == comparison.reference ? "reference" : nameOf(comparison.certaintyOf(run)));
    const std::string line = run.score ? scoreText(*run.score, share, certainty)
                                       : formatted("  %5s %12s  %13s  %13s  %8s%s\n", "-", "", "-",
                                                   "", share.c_str(), certainty.c_str());
    std::string place = run.rank ? std::to_string(run.rank) : "-";
    text +=
        std::string(4 - std::min<std::size_t>(4, place.size()), ' ') + place + "  " + name + line;
  }
  for (const ComparedRun& run : comparison.runs) {
    if (run.isScaleEstimated)
      text += printable(run.name) + formatted(": %.5f m per cell, estimated.\n", run.resolution);
  }
  return text;
}

}  // namespace roomgraph
