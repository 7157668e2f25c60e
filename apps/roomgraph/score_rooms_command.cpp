#include <cstdint>
#include <memory>
#include <set>

#include "commands.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/evaluation/score_rooms.h"
#include "roomgraph/images/read_labels.h"
#include "terminal.h"

namespace roomgraph {
namespace {

struct ScoreArguments {
  std::string labels, truth;
  bool isJson = false;
};

using Greys = std::set<std::uint32_t>;

constexpr std::uint32_t kFree = 254, kUnknown = 205;  // as ROS saves maps

/** Only what is free, unknown and wall in a map, which nobody takes for labels. */
bool areOfMap(const Greys& greys) {
  return greys.count(kFree) > 0 && allOf(greys, [](std::uint32_t grey) {
           return grey == 0 || grey == kFree || grey == kUnknown;
         });
}

/** A plan of other greys has no more of them, and the brightest is what is free. Labels of one or
 *  two rooms may look the same: what the other picture has tells them apart. */
bool mayBeOfPlan(const Greys& greys, const Greys& others) {
  return greys.size() <= 3 && greys.size() < others.size() && *greys.rbegin() > kUnknown &&
         *greys.rbegin() <= 255;
}

/** A map itself has labels, too, as far as one can see.
 *  @throws DataError where `map` is one. */
void refuseMap(const LabelMap& map, const LabelMap& other) {
  const Greys greys(map.label.begin(), map.label.end());
  const Greys others(other.label.begin(), other.label.end());
  if (areOfMap(greys) || mayBeOfPlan(greys, others))
    throw DataError(map.source.file +
                    ": is a map, as it has only the greys of what is free, unknown and wall: "
                    "give a picture with a label of its own for each room, from 1 on");
}

int run(const ScoreArguments& arguments) {
  const LabelMap labels = readLabels(arguments.labels), truth = readLabels(arguments.truth);
  refuseMap(labels, truth);
  refuseMap(truth, labels);
  if (allOf(truth.label, [](std::uint32_t l) { return l == 0; }))
    throw DataError(truth.source.file + ": has no room: all of it is black");
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
