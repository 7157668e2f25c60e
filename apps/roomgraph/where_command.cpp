#include <memory>

#include "commands.h"
#include "graph_of_map.h"
#include "option_arguments.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/rooms/find_route.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct WhereArguments {
  std::string map;
  Point place;
  OptionArguments options;
};

/** What kind of area it is, how large, and where its passages lead. */
std::string areaText(const GraphFile& file, AreaId id) {
  const Area& area = file.areas.areas[id.index()];
  std::string text =
      formatted("%s: %s of %.1f m2\n", areaName(file, id).c_str(),
                area.isRoom() ? "a room" : "a corridor", roomgraph::area(area.polygon));
  for (const PassageId p : area.passages) {
    const Passage& passage = file.areas.passages[p.index()];
    text += formatted("  passage %zu at (%.2f, %.2f), %.2f m wide, to %s\n", p.index(),
                      passage.middle().x, passage.middle().y, passage.width,
                      areaName(file, passage.a == id ? passage.b : passage.a).c_str());
  }
  return text;
}

int run(const WhereArguments& arguments) {
  const GraphFile file = graphOfMap(arguments.map, toOptions(arguments.options));
  const Whereabouts where = whereIs(file.graph, file.areas, arguments.place);
  std::string text = where.area ? areaText(file, where.area) : "in no room and no corridor\n";
  if (where.edge)
    text += formatted("  the nearest way is %.2f m off, at (%.2f, %.2f)\n",
                      distance(where.on, arguments.place), where.on.x, where.on.y);
  print(text);
  return kDone;
}

}  // namespace

std::function<int()> whereCommand(CLI::App& app) {
  const auto arguments = std::make_shared<WhereArguments>();
  addArgument(app, "MAP", arguments->map, "A map as for 'roomgraph extract', or its X.json.");
  addArgument(app, "X", arguments->place.x, "The place, in the frame of the map. (m)");
  addArgument(app, "Y", arguments->place.y, "The same. (m)");
  declareConfig(arguments->options, app);
  declareReading(arguments->options, app);
  declareRooms(arguments->options, app);
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
