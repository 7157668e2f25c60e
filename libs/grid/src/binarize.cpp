#include "roomgraph/grid/binarize.h"

#include <array>
#include <string>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** What each of the 256 grey levels means. */
using StateOfGrey = std::array<State, 256>;

StateOfGrey paperStates(int blackThreshold) {
  StateOfGrey states;
  for (int grey = 0; grey < 256; ++grey)
    states[std::size_t(grey)] = 3 * grey <= blackThreshold ? State::occupied : State::free;
  return states;
}

StateOfGrey threeStates(double occupiedAbove, double freeBelow) {
  constexpr double rounding = 1e-6;  // map_server compares in single precision
  StateOfGrey states;
  for (int grey = 0; grey < 256; ++grey) {
    const double occupied = 1 - grey / 255.0;
    states[std::size_t(grey)] = occupied <= freeBelow + rounding       ? State::free
                                : occupied >= occupiedAbove - rounding ? State::occupied
                                                                       : State::unknown;
  }
  return states;
}

void check(const GreyMap& map) {
  const GridFrame& frame = map.frame;
  if (frame.width < 0 || frame.height < 0 || map.grey.size() != frame.cellCount())
    throw UsageError("binarize: a map of " + std::to_string(map.grey.size()) +
                     " cells says that it is " + std::to_string(frame.width) + " x " +
                     std::to_string(frame.height));
  if (!map.grey.empty() && !frame.isSane())
    throw UsageError(
        "binarize: the side of a cell must be 0.0001 to 1000 m, and the origin of the "
        "map within 10000 km");
}

}  // namespace

void describe(BinarizeOptions& options, FieldTable& table) {
  const char* section = "binarize";
  table.count(
      section, "black_threshold", options.blackThreshold, 0, 765,
      "A cell is occupied where R + G + B is at most this, all others are free; 0 for three "
      "states.");
  table.number(
      section, "occupied_above", options.occupiedAbove, "", 0, 1,
      "A cell is occupied from this probability on; 0 for the threshold of the map's format.");
  table.number(section, "free_below", options.freeBelow, "", 0, 1,
               "A cell is free up to this probability; 0 for the threshold of the map's format.");
}

Grid binarize(const GreyMap& map, const BinarizeOptions& options) {
  check(map);
  const StateOfGrey states =
      options.blackThreshold > 0
          ? paperStates(options.blackThreshold)
          : threeStates(options.occupiedAbove > 0 ? options.occupiedAbove : map.occupiedAbove,
                        options.freeBelow > 0 ? options.freeBelow : map.freeBelow);
  Grid grid{map.frame, std::vector<State>(map.grey.size())};
  for (std::size_t i = 0; i < map.grey.size(); ++i) grid.cells[i] = states[map.grey[i]];
  return grid;
}

}  // namespace roomgraph
