#include <charconv>
#include <memory>

#include "commands.h"
#include "graph_of_map.h"
#include "option_arguments.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/rooms/find_route.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct RouteArguments {
  std::string map;
  std::vector<std::string> from, to;  ///< a room, or x and y
  OptionArguments options;
};

template <class Number>
bool isNumber(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  return std::from_chars(text.data(), end, number).ptr == end && !text.empty();
}

/** R3 is where its vertex stands; C7 the widest place of a corridor; or x and y [m]. */
Point placeOf(const GraphFile& file, const std::vector<std::string>& words, const char* option) {
  Point place;
  if (words.size() == 2 && isNumber(words[0], place.x) && isNumber(words[1], place.y)) return place;
  std::size_t number = 0;
  const std::string& word = words.front();
  if (words.size() == 1 && isNumber(word.substr(std::min<std::size_t>(1, word.size())), number)) {
    if (word[0] == 'R' && number < file.graph.rooms.size()) return file.graph.rooms[number].center;
    if (word[0] == 'C' && number < file.areas.areas.size())
      return file.areas.areas[number].widestPlace;
  }
  throw UsageError(
      formatted("%s takes a room of this map (R0 to R%zu), a corridor (C and the number "
                "of its area), or x and y in metres",
                option, std::max<std::size_t>(file.graph.rooms.size(), 1) - 1));
}

/** One line for each area and passage on the way. */
std::string routeText(const GraphFile& file, const Route& route, AreaId from, AreaId to) {
  const double width = 2 * route.minClearance - file.input.frame.resolution;
  std::string text = formatted("%.1f m, at least %.2f m wide\n  %s\n", route.length, width,
                               areaName(file, from).c_str());
  AreaId at = from;
  for (const PassageId p : route.passages) {
    const Passage& passage = file.areas.passages[p.index()];
    at = passage.a == at ? passage.b : passage.a;
    text += formatted("  passage %zu at (%.2f, %.2f), %.2f m wide, to %s\n", p.index(),
                      passage.middle().x, passage.middle().y, passage.width,
                      areaName(file, at).c_str());
  }
  if (at != to) text += "  " + areaName(file, to) + "\n";
  return text;
}

int run(const RouteArguments& arguments) {
  const GraphFile file = graphOfMap(arguments.map, toOptions(arguments.options));
  const Whereabouts from = whereIs(file.graph, file.areas, placeOf(file, arguments.from, "--from"));
  const Whereabouts to = whereIs(file.graph, file.areas, placeOf(file, arguments.to, "--to"));
  const auto route = findRoute(file.graph, file.areas, from, to);
  print(route ? routeText(file, *route, from.area, to.area)
              : "there is no way along the graph between these places\n");
  return route ? kDone : kBadData;
}

}  // namespace

std::function<int()> routeCommand(CLI::App& app) {
  const auto arguments = std::make_shared<RouteArguments>();
  addArgument(app, "MAP", arguments->map, "A map as for 'roomgraph extract', or its X.json.");
  const auto add = [&](const char* name, std::vector<std::string>& words, const char* sentence) {
    app.add_option(name, words, sentence)->type_name("PLACE")->required()->expected(1, 2);
  };
  add("--from", arguments->from, "Where to start: a room as R3, a corridor as C7, or x and y. (m)");
  add("--to", arguments->to, "Where to go, in the same words.");
  declareConfig(arguments->options, app);
  declareReading(arguments->options, app);
  declareRooms(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
