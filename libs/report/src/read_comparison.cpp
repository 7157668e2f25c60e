#include <cmath>

#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/json_parts.h"

namespace roomgraph {
namespace {

bool isTrue(const JsonNode& node) {
  if (!node.json.is_boolean()) throw Broken{node.place, "is neither true nor false"};
  return node.json.get<bool>();
}

/** What `read` makes of the node; none of null. */
template <class Read>
auto ifAny(const JsonNode& node, const Read& read) {
  return node.json.is_null() ? std::nullopt : std::optional(read(node));
}

std::optional<double> numberIfAny(const JsonNode& node) {
  return ifAny(node, [](const JsonNode& known) { return known.number(); });
}

std::vector<std::string> texts(const JsonNode& node) {
  return mapped(node.list(), &JsonNode::text);
}

std::size_t count(const JsonNode& node) { return node.countBelow(1'000'000'000); }

Transform2D pose(const JsonNode& node) {
  const std::vector<JsonNode> numbers = node.list();
  if (numbers.size() != 3) throw Broken{node.place, "is not a pose [x, y, phi]"};
  return {readCoordinate(numbers[0]), readCoordinate(numbers[1]), numbers[2].number()};
}

/** "name" of each member, in the order of the file. */
std::vector<std::pair<std::string, JsonNode>> members(const JsonNode& node) {
  if (!node.json.is_object()) throw Broken{node.place, "is not an object"};
  std::vector<std::pair<std::string, JsonNode>> all;
  for (const auto& item : node.json.items())
    all.push_back({item.key(), {item.value(), node.place + "." + item.key()}});
  return all;
}

std::vector<Measure> measures(const JsonNode& node) {
  std::vector<Measure> all;
  for (const auto& [name, one] : members(node)) {
    all.push_back({name, numberIfAny(one["value"]), one["unit"].text(), one["support"].number(),
                   numberIfAny(one["low"]), numberIfAny(one["high"]), isTrue(one["meaningful"])});
    if (one.contains("x")) all.back().place = Point{one["x"].number(), one["y"].number()};
  }
  return all;
}

std::pair<std::size_t, std::size_t> keyFrames(const JsonNode& node) {
  const std::vector<JsonNode> both = node.list();
  if (both.size() != 2) throw Broken{node.place, "is not two key frames"};
  return {count(both[0]), count(both[1])};
}

std::optional<RunScore> score(const JsonNode& node) {
  if (node["score"].json.is_null()) return std::nullopt;
  const auto number = [&](const char* name) { return node[name].number(); };
  RunScore score;
  score.score = number("score"), score.low = number("score_low"), score.high = number("score_high");
  score.mapError = number("map_error_m"), score.errorLow = number("map_error_low");
  score.errorHigh = number("map_error_high"), score.share = number("shared_walls");
  score.support = number("compared_walls"), score.others = count(node["others"]);
  score.trust = number("trust"), score.confirmed = number("confirmed");
  score.contradicted = number("contradicted"), score.jitter = number("jitter_m");
  score.scale = number("scale"), score.isScaleDisputed = isTrue(node["scale_disputed"]);
  score.isMeaningful = isTrue(node["meaningful"]);
  if (node.contains("given_up")) score.givenUp = number("given_up");
  return score;
}

PathPose pathPose(const JsonNode& node) {
  return {count(node["key_frame"]),
          numberIfAny(node["time"]),
          {readCoordinate(node["x"]), readCoordinate(node["y"]), node["phi"].number()},
          numberIfAny(node["error_m"])};
}

ComparedRun run(const JsonNode& node) {
  ComparedRun run;
  run.name = node["name"].text(), run.file = node["file"].text();
  if (node.contains("relative_path")) run.relativePath = node["relative_path"].text();
  run.sha256 = node["sha256"].text();
  run.pose = pose(node["pose"]);
  run.score = score(node);
  if (node.contains("welded")) run.welded = keyFrames(node["welded"]);
  run.rank = node["rank"].json.is_null() ? 0 : count(node["rank"]);
  run.measures = measures(node["measures"]);
  run.reason = node["reason"].text();
  run.resolution = node["resolution"].number();
  run.isScaleEstimated = isTrue(node["scale_estimated"]);
  run.path = mapped(node["path"].list(), pathPose);
  return run;
}

ComparedPair pair(const JsonNode& node) {
  ComparedPair pair;
  pair.a = node["a"].text(), pair.b = node["b"].text();
  pair.isSameSite = isTrue(node["same_site"]);
  pair.transform = ifAny(node["transform"], pose);
  pair.confidence = node["confidence"].number(), pair.overlap = node["overlap"].number();
  if (const JsonNode next = node["runner_up"]; !next.json.is_null()) {
    pair.runnerUp = pose(next["transform"]);
    pair.runnerUpConfidence = next["confidence"].number();
  }
  pair.measures = measures(node["measures"]);
  if (node.contains("one_picture")) {
    const std::string told = node["one_picture"].text();
    if (told != "copies" && told != "edits")
      throw Broken{node["one_picture"].place, "is neither copies nor edits"};
    (told == "copies" ? pair.areCopies : pair.areEdits) = true;
  }
  return pair;
}

MapBreak mapBreak(const JsonNode& node) {
  return {node["run"].text(),
          readPlace(node),
          node["rotation_deg"].number() * M_PI / 180,
          node["shift_m"].number(),
          ifAny(node["key_frame"], count),
          numberIfAny(node["time"]),
          ifAny(node["pose_drawn"], [&](const JsonNode& drawn) {
            return TornPose{pose(drawn), pose(node["pose_untorn"])};
          })};
}

RoomSighting sighting(const JsonNode& node) {
  if (const auto known = valueOfName<RoomSighting>(node.text())) return *known;
  throw Broken{node.place, "is none of seen, gone and unvisited"};
}

RoomInRun roomInRun(const JsonNode& node) {
  RoomInRun in;
  in.run = node["run"].text();
  in.sighting = sighting(node["sighting"]);
  in.pieces = int(count(node["pieces"])), in.isMerged = isTrue(node["merged"]);
  in.shift = numberIfAny(node["shift_m"]), in.areaChange = numberIfAny(node["area_change"]);
  in.boundaryAgreement = numberIfAny(node["boundary_agreement"]);
  in.lengthError = numberIfAny(node["length_error_m"]);
  in.doorsGained = int(count(node["doors_gained"])), in.doorsLost = int(count(node["doors_lost"]));
  return in;
}

SiteRoom room(const JsonNode& node) {
  SiteRoom room;
  room.id = node["id"].text(), room.name = node["name"].text();
  room.isCorridor = node["kind"].text() == "corridor";
  room.center = readPlace(node);
  room.area = node["area_m2"].number();
  room.polygon = readPolygon(node);
  for (const JsonNode& door : node["doors"].list())
    room.doors.push_back({readPlace(door), door["width"].number(),
                          door["to"].json.is_null() ? "" : door["to"].text(),
                          texts(door["seen_in"]), texts(door["lost_in"])});
  room.runs = mapped(node["runs"].list(), roomInRun);
  return room;
}

/** Unit and sentence are this version's; an option that it does not know has none. */
UsedOption option(const std::string& section, const std::string& name, const JsonNode& node) {
  static const std::vector<UsedOption> known = usedOptions({});
  UsedOption used{section, name, node.json.is_string() ? node.text() : node.json.dump(), "", ""};
  for (const UsedOption& one : known)
    if (one.section == section && one.name == name)
      used.unit = one.unit, used.sentence = one.sentence;
  return used;
}

std::optional<GateVerdict> gate(const JsonNode& node) {
  if (node.json.is_null()) return std::nullopt;
  return GateVerdict{texts(node["complaints"]), texts(node["candidates"]), texts(node["asked"]),
                     texts(node["margins"])};
}

Comparison comparison(const JsonNode& top) {
  if (top["version"].json != 1)
    throw Broken{"version", "is not 1, the only one this program reads"};
  Comparison result;
  result.reference = ifAny(top["reference"], [](const JsonNode& name) { return name.text(); });
  if (top.contains("reference_doubled_m"))
    result.referenceDoubled = top["reference_doubled_m"].number();
  if (top.contains("core")) result.core = texts(top["core"]);
  result.isOneDrive = top.contains("one_drive") && isTrue(top["one_drive"]);
  result.runs = mapped(top["runs"].list(), run);
  result.pairs = mapped(top["pairs"].list(), pair);
  for (const JsonNode& node : top["left_out"].list())
    result.leftOut.push_back({node["name"].text(), node["file"].text(), node["reason"].text(),
                              isTrue(node["other_site"])});
  result.rooms = mapped(top["rooms"].list(), room);
  result.breaks = mapped(top["breaks"].list(), mapBreak);
  for (const auto& [section, keys] : members(top["options"]))
    for (const auto& [name, node] : members(keys))
      result.options.push_back(option(section, name, node));
  result.gate = gate(top["gate"]);
  result.files = texts(top["files"]);
  result.verdict = top["verdict"].text();
  return result;
}

}  // namespace

Comparison parseComparisonJson(const std::string& text, const std::string& name) {
  return readDocument(text, name, "roomgraph/comparison", "write it anew with 'roomgraph compare'",
                      comparison);
}

Comparison readComparison(const std::string& file) {
  return parseComparisonJson(readFile(file), file);
}

}  // namespace roomgraph
