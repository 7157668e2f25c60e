#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "commands.h"
#include "option_arguments.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/graph_files/GraphFile.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/ExtractOptions.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/rooms/find_route.h"
#include "terminal.h"

namespace roomgraph {
namespace {

/** A map that is asked for its places. */
struct AskedMap {
  std::string name;
  GraphFile file;
  Grid grid;  ///< empty of an X.json, which has none
};

/** The graph in an X.json of 'roomgraph extract', or else that of a map, extracted now. */
AskedMap readAskedMap(const std::string& file, const ExtractOptions& options) {
  if (firstLetter(CheckedFile(file).head().text()) == '{') return {file, readGraphJson(file), {}};
  GreyMap map = loadGrid(file, options.loadGrid);
  printWarnings(file, map.notes);
  Stages stages = extractGraph(std::move(map), options);
  return {file, graphFile(stages), std::move(stages.grid)};
}

/** The name that was given to it; where none were given "R3" for a room, and "C7" for a corridor by
 *  the number of its area. */
std::string areaName(const GraphFile& file, AreaId area) {
  if (!file.areaNames.empty()) return file.areaNames.at(area.index());
  const Area& found = file.areas.areas[area.index()];
  return found.isRoom() ? "R" + std::to_string(found.room.index())
                        : "C" + std::to_string(area.index());
}

/** The other area of a passage. */
AreaId behind(const Passage& passage, AreaId area) {
  return passage.a == area ? passage.b : passage.a;
}

std::string passageLine(const GraphFile& file, PassageId id, AreaId to) {
  const Passage& passage = file.areas.passages[id.index()];
  return formatted("  passage %zu at (%.2f, %.2f), %.2f m wide, to %s\n", id.index(),
                   passage.middle().x, passage.middle().y, passage.width,
                   to ? areaName(file, to).c_str() : "space that was hardly seen");
}

std::string placeText(Point place) { return formatted("(%.2f, %.2f)", place.x, place.y); }

/** Whether a place is in free space, as far as a map tells. */
bool mayBeFree(const AskedMap& asked, Point place) {
  return asked.grid.cells.empty() || asked.grid.isFree(place);
}

/** Where a place is. @throws DataError where it is in no area, or not in free space; each free cell
 *  is in one. */
Whereabouts whereItIs(const AskedMap& asked, Point place) {
  const Whereabouts where = whereIs(asked.file.graph, asked.file.areas, place);
  const std::string at = asked.name + ": " + placeText(place);
  if (!where.area) {
    const std::string off = formatted("%.2f m off, at ", distance(where.on, place));
    throw DataError(at + " lies in no room and no corridor" +
                    (where.edge ? ", and the nearest way is " + off + placeText(where.on) : "") +
                    ": give a place in free space");
  }
  if (!mayBeFree(asked, place))
    throw DataError(at + " lies in an obstacle or in unknown space: give a place in free space");
  return where;
}

struct RouteArguments {
  std::string map;
  std::vector<std::string> from, to;  ///< a room, or x and y
  OptionArguments options;
};

/** Whether a place may lie on a map; not so what is infinite or no number. */
bool isPlace(Point place) {
  return std::abs(place.x) < kFarthestPlace && std::abs(place.y) < kFarthestPlace;
}

/** Where one stands that is in an area: where the vertex of a room is, or on a way through a
 *  corridor, next to its widest place: there may be clutter, or it may be open to outside. */
Point placeInArea(const GraphFile& file, AreaId id) {
  const Area& area = file.areas.areas[id.index()];
  if (area.isRoom()) return file.graph.rooms[area.room.index()].center;
  Point nearest = area.widestPlace;
  double least = HUGE_VAL;
  for (const Edge& edge : file.graph.graph.edges())
    for (const Point point : edge.path.points)
      if (const double far = distance(point, area.widestPlace);
          far < least && sideOf(area.polygon, point) == Side::inside)
        nearest = point, least = far;
  return nearest;
}

/** "R0 to R11", or the names that were given. */
std::string knownAreas(const GraphFile& file) {
  constexpr std::size_t kMostNames = 10;
  if (!file.areaNames.empty()) return listed(file.areaNames, kMostNames);
  const std::string corridors = "C and the number of the area of a corridor";
  if (file.graph.rooms.empty()) return "it has no room; " + corridors;
  return formatted("R0 to R%zu, ", file.graph.rooms.size() - 1) + corridors;
}

/** An area by what it is called, see areaName; or x and y [m]. */
Point placeOf(const GraphFile& file, const std::vector<std::string>& words, const char* option) {
  Point place;
  if (words.size() == 2 && parseNumber(words[0], place.x) && parseNumber(words[1], place.y) &&
      isPlace(place))
    return place;
  for (std::size_t a = 0; a < file.areas.areas.size() && words.size() == 1; ++a)
    if (areaName(file, AreaId(a)) == words[0]) return placeInArea(file, AreaId(a));
  throw UsageError(std::string(option) + " takes a room or corridor of this map (" +
                   knownAreas(file) + "), or x and y in metres, such as '" + option + " 1.5 2'");
}

/** Whether all is free between a place and the way next to it. */
bool isFreeToWay(const AskedMap& asked, const Whereabouts& where) {
  const int steps =
      1 + int(2 * distance(where.place, where.on) / asked.file.input.frame.resolution);
  for (int i = 0; i < steps; ++i)
    if (!mayBeFree(asked, where.place + double(i) / steps * (where.on - where.place))) return false;
  return true;
}

/** One line for each area and passage on the way. */
std::string routeText(const AskedMap& asked, const Route& route, const Whereabouts& from,
                      const Whereabouts& to) {
  const GraphFile& file = asked.file;
  const double width = 2 * route.minClearance - file.input.frame.resolution;
  std::string text = formatted("%.1f m, at least %.2f m wide", route.length, width);
  if (route.besideWays > file.input.frame.resolution) {
    text +=
        formatted(" except for %.1f m in a straight line to and from the ways", route.besideWays);
    if (!isFreeToWay(asked, from) || !isFreeToWay(asked, to)) text += ", not all of it free";
  }
  text += "\n  " + areaName(file, from.area) + "\n";
  AreaId at = from.area;
  for (const PassageId p : route.passages) {
    at = behind(file.areas.passages[p.index()], at);
    text += passageLine(file, p, at);
  }
  if (at != to.area) text += "  " + areaName(file, to.area) + "\n";
  return text;
}

std::string noRouteText(const GraphFile& file, const Whereabouts& from, const Whereabouts& to,
                        double leastWidth) {
  const std::string wide = leastWidth > 0 ? formatted(" that is %.2f m wide", leastWidth) : "";
  if (from.area != to.area || from.edge)
    return "there is no way along the graph" + wide + " between these places\n";
  return "both places lie in " + areaName(file, from.area) + ", which has no ways\n";
}

int run(const RouteArguments& arguments) {
  const ExtractOptions options = toOptions(arguments.options);
  const AskedMap asked = readAskedMap(arguments.map, options);
  const GraphFile& file = asked.file;
  const auto find = [&](const std::vector<std::string>& words, const char* option) {
    return whereItIs(asked, placeOf(file, words, option));
  };
  const Whereabouts from = find(arguments.from, "--from"), to = find(arguments.to, "--to");
  const double width = arguments.options.robotWidth ? options.roomGraph.robotWidth : 0;
  const double clearance = width > 0 ? (width + file.input.frame.resolution) / 2 : 0;
  const auto route = findRoute(file.graph, file.areas, from, to, clearance);
  print(route ? routeText(asked, *route, from, to) : noRouteText(file, from, to, width));
  return route ? kDone : kBadData;
}

struct WhereArguments {
  std::string map;
  Point place;
  OptionArguments options;
};

/** What kind of area it is, how large, and where its passages lead. */
std::string areaText(const GraphFile& file, AreaId id) {
  const Area& area = file.areas.areas[id.index()];
  std::string text =
      formatted("%s: %s of %.1f m2", areaName(file, id).c_str(),
                area.isRoom() ? "a room" : "a corridor", roomgraph::area(area.polygon));
  if (area.seen) text += formatted(", %.0f %% of its outline seen", 100 * *area.seen);
  text += "\n";
  for (const PassageId p : area.passages)
    text += passageLine(file, p, behind(file.areas.passages[p.index()], id));
  return text;
}

int run(const WhereArguments& arguments) {
  if (!isPlace(arguments.place)) throw UsageError("where: X and Y are no place: give metres");
  const AskedMap asked = readAskedMap(arguments.map, toOptions(arguments.options));
  const Whereabouts where = whereItIs(asked, arguments.place);
  std::string text = areaText(asked.file, where.area);
  if (where.edge)
    text += formatted("  the nearest way is %.2f m off, at (%.2f, %.2f)\n",
                      distance(where.on, arguments.place), where.on.x, where.on.y);
  print(text);
  return kDone;
}

}  // namespace

std::function<int()> routeCommand(CLI::App& app) {
  const auto arguments = std::make_shared<RouteArguments>();
  addArgument(app, "MAP", arguments->map, "A map as for 'roomgraph extract', or its X.json.");
  const auto add = [&](const char* name, std::vector<std::string>& words, const char* sentence) {
    app.add_option(name, words, sentence)->type_name("PLACE")->required()->expected(1, 2);
  };
  add("--from", arguments->from,
      "Where to start: a room or corridor by name (R3 or C7 if it has none), or x and y. (m)");
  add("--to", arguments->to, "Where to go: given as for --from.");
  declareOptions(arguments->options, app);
  declareRooms(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

std::function<int()> whereCommand(CLI::App& app) {
  const auto arguments = std::make_shared<WhereArguments>();
  addArgument(app, "MAP", arguments->map, "A map as for 'roomgraph extract', or its X.json.");
  addArgument(app, "X", arguments->place.x, "The place, in the frame of the map. (m)");
  addArgument(app, "Y", arguments->place.y, "The same. (m)");
  declareOptions(arguments->options, app);
  declareRooms(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
