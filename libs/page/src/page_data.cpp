#include "page_data.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/page/site_pictures.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {
namespace {

Json boxJson(const Box& box) { return {pointJson(box.low), pointJson(box.high)}; }

Json pictureJson(const SitePicture& picture) {
  if (picture.png.empty()) return nullptr;
  return {{"box", boxJson(picture.box)}, {"url", "data:image/png;base64," + base64(picture.png)}};
}

/** [x, y, x, y, ...], to the centimetre. */
Json placesJson(const std::vector<Point>& places) {
  Json numbers = Json::array();
  for (const Point p : places)
    for (const double value : {p.x, p.y}) numbers.push_back(std::round(100 * value) / 100);
  return numbers;
}

Json scansJson(const Comparison& comparison, const Fault& fault, const std::vector<Run>& runs) {
  const BreakScans scans = breakScans(comparison, fault, runs);
  return {{"before", placesJson(scans.before)}, {"behind", placesJson(scans.behind)}};
}

/** The maps of the compared runs; without a map where there is none. */
std::vector<PlacedMap> placedMaps(const Comparison& comparison, const std::vector<Run>& runs) {
  return mapped(comparison.runs, [&](const ComparedRun& compared) {
    const Run* run = findRun(runs, compared.name);
    return PlacedMap{run ? &run->map : nullptr, compared.pose};
  });
}

/** Two cells of the coarsest map, so that turned maps leave no gaps. */
double heatCellOf(const Box& site, const std::vector<PlacedMap>& maps) {
  double cell = pixelFor(site, {}, 1000);
  for (const PlacedMap& placed : maps) cell = std::max(cell, 2 * placed.map->frame.resolution);
  return cell;
}

/** JSON never needs these characters but in strings, where they may be written as numbers. */
std::string safeInScript(const std::string& json) {
  std::string text;
  text.reserve(json.size() + 64);
  for (const char c : json)
    if (c == '<' || c == '>' || c == '&')
      text += formatted("\\u%04x", unsigned(c));
    else
      text += c;
  return text;
}

/** What can be drawn without any map. */
Box boxOfRooms(const Comparison& comparison) {
  Box box;
  for (const SiteRoom& room : comparison.rooms)
    for (const Point p : room.polygon.outer) box.include(p);
  for (const ComparedRun& run : comparison.runs)
    for (const PathPose& pose : run.path) box.include(pose.pose.shift());
  return box.isEmpty() ? Box{{0, 0}, {1, 1}} : box;
}

std::vector<Point> thinned(const std::vector<Point>& places) {
  constexpr std::size_t most = 250;
  const std::size_t step = (places.size() + most - 1) / most;
  std::vector<Point> some;
  for (std::size_t i = 0; i < places.size(); i += std::max<std::size_t>(1, step))
    some.push_back(places[i]);
  return some;
}

}  // namespace

std::string colourText(std::size_t run) {
  const Colour c = runColour(run);
  return formatted("#%02x%02x%02x", unsigned(c.red), unsigned(c.green), unsigned(c.blue));
}

std::string fixedText(std::optional<double> value, int digits) {
  if (!value || !std::isfinite(*value)) return "–";
  return formatted("%.*f", digits, rounded(*value)).substr(0, 59);
}

std::string percentText(double share) { return fixedText(100 * rounded(share), 0) + " %"; }

std::string pageDocument(const Comparison& comparison) {
  Comparison shown = comparison;
  for (ComparedRun& run : shown.runs) run.relativePath.clear();  // nobody else's business
  return safeInScript(comparisonJson(shown));
}

std::string pageData(const Comparison& comparison, const std::vector<Run>& runs) {
  std::vector<PlacedMap> placed = placedMaps(comparison, runs);
  const double turn = uprightTurn(comparison, runs);
  for (PlacedMap& map : placed) map.pose = Transform2D{0, 0, turn} * map.pose;
  std::vector<PlacedMap> known = placed;
  eraseIf(known, [](const PlacedMap& map) { return !map.map; });
  const Box site = known.empty() ? boxOfRooms(comparison) : knownBox(known);
  const double pixel = pixelFor(site, known, placed.size() > 20 ? 1200 : 2500);
  // Of free space, so that what all runs share is not too dark.
  const auto faint =
      std::uint8_t(std::clamp<std::size_t>(120 / std::max<std::size_t>(1, placed.size()), 8, 45));
  Json runsJson = Json::array();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const SitePicture picture =
        placed[i].map ? runPicture(placed[i], {runColour(i), runPattern(i), faint}, pixel)
                      : SitePicture{};
    const Measure* added = comparison.runs[i].addedWalls();
    runsJson.push_back({{"colour", colourText(i)},
                        {"shape", runShape(i)},
                        {"picture", pictureJson(picture)},
                        {"added", added ? pointJson(*added->place) : Json()}});
  }
  const SitePicture heat = heatPicture(disagreementOf(known, heatCellOf(site, known)));
  const auto scansAt = [&](const Fault& fault) { return scansJson(comparison, fault, runs); };
  const Json data = {{"turn", turn},
                     {"box", boxJson(site)},
                     {"hasMaps", !known.empty()},
                     {"heat", pictureJson(heat)},
                     {"runs", std::move(runsJson)},
                     {"breaks", mapped(faultsOf(comparison), scansAt)}};
  return safeInScript(data.dump());
}

BreakScans breakScans(const Comparison& comparison, const Fault& fault,
                      const std::vector<Run>& runs) {
  const Run* run = findRun(runs, fault.run);
  const ComparedRun* placed = findRun(comparison.runs, fault.run);
  if (!run || !placed) return {};
  const Motion2D move(placed->pose);
  BreakScans scans;
  for (const ScanWalls& scan : run->scans) {
    const bool isBehind = fault.later.holds(scan.keyFrame);
    if (!isBehind && !fault.earlier.holds(scan.keyFrame)) continue;
    for (const WallPoint& wall : scan.walls)
      (isBehind ? scans.behind : scans.before).push_back(move(wall.place));
  }
  return {thinned(scans.before), thinned(scans.behind)};
}

std::string base64(const std::string& bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '\0');
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                  reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
  return text;
}

}  // namespace roomgraph
