#include "score_rooms_command.h"

#include <memory>

#include "Command.h"
#include "roomgraph/evaluation/score_rooms.h"
#include "roomgraph/evaluation/write_score.h"
#include "roomgraph/images/read_labels.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct ScoreArguments {
  std::string labels, truth;
  bool isJson = false;
};

int run(const ScoreArguments& arguments) {
  const LabelMap labels = readLabels(arguments.labels), truth = readLabels(arguments.truth);
  const RoomScore score = scoreRooms(labels, truth);
  print(arguments.isJson ? roomScoreJson(score) : roomScoreText(score));
  return kDone;
}

}  // namespace

std::function<int()> scoreRoomsCommand(CLI::App& app) {
  const auto arguments = std::make_shared<ScoreArguments>();
  app.add_option("LABELS", arguments->labels,
                 "The rooms to judge: a picture whose pixels say which room they are in, such as "
                 "X.areas.png. Grey png or pgm: the grey level, 0 for none. Colour png: the "
                 "colour, black and white for none.")
      ->type_name("")
      ->required();
  app.add_option("TRUTH", arguments->truth,
                 "The rooms as they should be: the same kind of picture, in the same size.")
      ->type_name("")
      ->required();
  app.add_flag("--json", arguments->isJson,
               "Print JSON, with all counts; shares in percent, areas in pixels.");
  return [arguments] { return run(*arguments); };
}

}  // namespace roomgraph
