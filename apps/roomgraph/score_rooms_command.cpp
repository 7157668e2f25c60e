#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>

#include "commands.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/evaluation/score_rooms.h"
#include "roomgraph/images/read_labels.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct ScoreArguments {
  std::string labels, truth;
  bool isJson = false;
};

/** A map itself has labels, too, as far as one can see: what is free, and what is unknown. */
LabelMap readRooms(const std::string& file) {
  LabelMap map = readLabels(file);
  const std::set<std::uint32_t> labels(map.label.begin(), map.label.end());
  constexpr std::uint32_t free = 254, unknown = 205;
  const auto isOfRooms = [](std::uint32_t l) { return l != 0 && l != free && l != unknown; };
  if (labels.count(free) > 0 && std::none_of(labels.begin(), labels.end(), isOfRooms))
    throw DataError(file +
                    ": is a map, as it has only the greys of what is free, unknown and wall: "
                    "give a picture with a label of its own for each room");
  return map;
}

int run(const ScoreArguments& arguments) {
  const LabelMap labels = readRooms(arguments.labels), truth = readRooms(arguments.truth);
  const RoomScore score = scoreRooms(labels, truth);
  print(arguments.isJson ? roomScoreJson(score) : roomScoreText(score));
  return kDone;
}

}  // namespace

std::function<int()> scoreRoomsCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ScoreArguments>();
  addArgument(app, "LABELS", arguments->labels,
              "The rooms to judge: a picture whose pixels say which room they are in, such as "
              "X.areas.png. Grey png or pgm: the grey level, 0 for none. Colour png: the "
              "colour, black and white for none.");
  addArgument(app, "TRUTH", arguments->truth,
              "The rooms as they should be: the same kind of picture, in the same size.");
  app.add_flag("--json", arguments->isJson,
               "Print JSON, with all counts; shares in percent, areas in pixels.");
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
