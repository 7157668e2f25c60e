#include "page_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "base64.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/json/rounded.h"
#include "site_pictures.h"

namespace roomgraph {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostPixels = 2500, kMostPixelsOfMany = 1200, kMostHeatCells = 1000;
constexpr std::size_t kManyRuns = 20;
constexpr std::size_t kFaintSum = 90;  // opacity of free space that all runs share, of 255

Json number(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return rounded(*value);
}

Json pointJson(Point p) { return {number(p.x), number(p.y)}; }

Json ringJson(const Ring& ring) {
  Json points = Json::array();
  for (const Point p : ring) points.push_back(pointJson(p));
  return points;
}

Json boxJson(const Box& box) { return {pointJson(box.low), pointJson(box.high)}; }

Json pictureJson(const SitePicture& picture) {
  if (picture.png.empty()) return nullptr;
  return {{"box", boxJson(picture.box)}, {"url", "data:image/png;base64," + base64(picture.png)}};
}

/** The maps of the compared runs; without a map where there is none. */
std::vector<PlacedMap> placedMaps(const Comparison& comparison, const std::vector<Run>& runs) {
  std::map<std::string, const MapForAlignment*> maps;
  for (const Run& run : runs) maps.emplace(run.name, &run.map);
  std::vector<PlacedMap> placed;
  for (const ComparedRun& run : comparison.runs) {
    const auto found = maps.find(run.name);
    placed.push_back({found == maps.end() ? nullptr : found->second, run.pose});
  }
  return placed;
}

/** Two cells of the coarsest map, so that turned maps leave no gaps. */
double heatCellOf(const Box& site, const std::vector<PlacedMap>& maps) {
  double cell = pixelFor(site, {}, kMostHeatCells);
  for (const PlacedMap& placed : maps) cell = std::max(cell, 2 * placed.map->frame.resolution);
  return cell;
}

/** [x, y, error] of each key frame; the error is null where it cannot be told. */
Json pathJson(const std::vector<PathPose>& path) {
  Json points = Json::array();
  for (const PathPose& at : path)
    points.push_back({number(at.pose.x), number(at.pose.y), number(at.error)});
  return points;
}

Json poseJson(const Transform2D& pose) {
  return {number(pose.x), number(pose.y), number(pose.phi)};
}

Json runJson(const ComparedRun& run, std::size_t index, const SitePicture& picture) {
  const auto of = [&](double RunScore::*member) {
    return run.score ? number((*run.score).*member) : Json(nullptr);
  };
  return {{"name", utf8Text(run.name)},
          {"rank", run.rank},
          {"score", {of(&RunScore::low), of(&RunScore::score), of(&RunScore::high)}},
          {"error", {of(&RunScore::errorLow), of(&RunScore::mapError), of(&RunScore::errorHigh)}},
          {"meaningful", run.score && run.score->isMeaningful},
          {"colour", colourText(index)},
          {"shape", runShape(index)},
          {"path", pathJson(run.path)},
          {"picture", pictureJson(picture)}};
}

const char* sightingName(RoomSighting sighting) {
  switch (sighting) {
    case RoomSighting::seen:
      return "seen";
    case RoomSighting::gone:
      return "gone";
    case RoomSighting::unvisited:
      break;
  }
  return "unvisited";
}

Json roomInRunJson(const RoomInRun& room, const std::map<std::string, std::size_t>& runs) {
  const auto found = runs.find(room.run);
  return {{"run", found == runs.end() ? Json(nullptr) : Json(found->second)},
          {"sighting", sightingName(room.sighting)},
          {"pieces", room.pieces},
          {"merged", room.isMerged},
          {"shift", number(room.shift)},
          {"area", number(room.areaChange)},
          {"outline", number(room.boundaryAgreement)},
          {"length", number(room.lengthError)},
          {"gained", room.doorsGained},
          {"lost", room.doorsLost}};
}

Json roomJson(const SiteRoom& room, const std::map<std::string, std::size_t>& runs) {
  Json rings = Json::array(), sightings = Json::array();
  if (!room.polygon.outer.empty()) rings.push_back(ringJson(room.polygon.outer));
  for (const Ring& hole : room.polygon.holes) rings.push_back(ringJson(hole));
  for (const RoomInRun& one : room.runs) sightings.push_back(roomInRunJson(one, runs));
  return {{"id", utf8Text(room.id)},     {"name", utf8Text(room.name)},
          {"corridor", room.isCorridor}, {"center", pointJson(room.center)},
          {"area", number(room.area)},   {"rings", std::move(rings)},
          {"runs", std::move(sightings)}};
}

Json breakJson(const MapBreak& bend, const std::map<std::string, std::size_t>& runs) {
  const auto found = runs.find(bend.run);
  return {{"run", found == runs.end() ? Json(nullptr) : Json(found->second)},
          {"place", pointJson(bend.place)},
          {"turn", number(bend.rotation * 180 / M_PI)},
          {"shift", number(bend.shift)},
          {"frame", bend.keyFrame ? Json(*bend.keyFrame) : Json()},
          {"drawn", bend.torn ? poseJson(bend.torn->drawn) : Json()},
          {"untorn", bend.torn ? poseJson(bend.torn->untorn) : Json()}};
}

/** JSON never needs these characters but in strings, where they may be written as numbers. */
std::string safeInScript(const std::string& json) {
  std::string text;
  text.reserve(json.size() + 64);
  for (const char c : json) switch (c) {
      case '<':
        text += "\\u003c";
        break;
      case '>':
        text += "\\u003e";
        break;
      case '&':
        text += "\\u0026";
        break;
      default:
        text += c;
    }
  return text;
}

}  // namespace

std::string colourText(std::size_t run) {
  const Colour c = runColour(run);
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(c.red), unsigned(c.green),
                unsigned(c.blue));
  return text;
}

std::string fixedText(std::optional<double> value, int digits) {
  if (!value || !std::isfinite(*value)) return "–";
  char text[60];
  std::snprintf(text, sizeof text, "%.*f", digits, *value + 0.0);
  return text;
}

std::string percentText(double share) { return fixedText(100 * share, 0) + " %"; }

std::string pageData(const Comparison& comparison, const std::vector<Run>& runs) {
  const std::vector<PlacedMap> placed = placedMaps(comparison, runs);
  std::vector<PlacedMap> known = placed;
  known.erase(std::remove_if(known.begin(), known.end(),
                             [](const PlacedMap& map) { return map.map == nullptr; }),
              known.end());
  const Box site = knownBox(known);
  const double pixel =
      pixelFor(site, known, placed.size() > kManyRuns ? kMostPixelsOfMany : kMostPixels);
  const auto faint = std::uint8_t(
      std::clamp<std::size_t>(kFaintSum / std::max<std::size_t>(1, placed.size()), 8, 30));
  std::map<std::string, std::size_t> index;
  Json runsJson = Json::array(), rooms = Json::array(), breaks = Json::array();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    index.emplace(comparison.runs[i].name, i);
    const SitePicture picture =
        placed[i].map ? runPicture(placed[i], runColour(i), faint, pixel) : SitePicture{};
    runsJson.push_back(runJson(comparison.runs[i], i, picture));
  }
  for (const SiteRoom& room : comparison.rooms) rooms.push_back(roomJson(room, index));
  for (const MapBreak& bend : comparison.breaks) breaks.push_back(breakJson(bend, index));
  const SitePicture heat = heatPicture(disagreementOf(known, heatCellOf(site, known)));
  const Json data = {{"box", boxJson(site)},
                     {"runs", std::move(runsJson)},
                     {"heat", pictureJson(heat)},
                     {"rooms", std::move(rooms)},
                     {"breaks", std::move(breaks)}};
  return safeInScript(data.dump());
}

}  // namespace roomgraph
