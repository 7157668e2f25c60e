#include "odd_maps.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "random_maps.h"

namespace roomgraph::test {
namespace {

constexpr std::uint8_t kOccupied = 0, kUnknown = 128, kFree = 255;

using Cells = std::vector<std::uint8_t>;

void noise(Cells& cells, ByteSource& bytes) {
  const unsigned occupied = bytes.byte(), unknown = occupied + bytes.byte() / 2;
  std::mt19937 random(bytes.below(65536));
  for (std::uint8_t& cell : cells) {
    const unsigned roll = random() % 384;
    cell = roll < occupied ? kOccupied : roll < unknown ? kUnknown : kFree;
  }
}

/** Squares in turn, or corridors of one width that a comb or a spiral would have. */
void pattern(Cells& cells, const GridFrame& frame, ByteSource& bytes) {
  const int side = 1 + int(bytes.below(8)), gap = 1 + int(bytes.below(12));
  const bool isComb = bytes.flag();
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const bool inX = x % (side + gap) < side, inY = y % (side + gap) < side;
      const bool isWall = isComb ? inX && y > gap : inX != inY;
      if (isWall) cells[frame.index({x, y})] = kOccupied;
    }
}

void strokes(Cells& cells, const GridFrame& frame, ByteSource& bytes) {
  std::vector<Stroke> list(1 + bytes.below(30));
  for (Stroke& s : list) s = {bytes.byte(), bytes.byte(), bytes.byte(), bytes.byte(), bytes.byte()};
  const MapText text = painted(std::max(3, frame.width), std::max(3, frame.height), 1, list);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const char c = text.cells[std::size_t(y) * std::size_t(text.width) + std::size_t(x)];
      cells[frame.index({x, y})] = c == '#' ? kOccupied : c == '.' ? kFree : kUnknown;
    }
}

/** Single cells, each of them moved by the fuzzer. */
void specks(Cells& cells, ByteSource& bytes) {
  constexpr std::uint8_t kGreys[] = {kOccupied, kUnknown, kFree};
  const unsigned count = bytes.below(64);
  for (unsigned i = 0; i < count; ++i)
    cells[bytes.below(65536) % cells.size()] = bytes.oneOf(kGreys);
}

}  // namespace

GreyMap oddMap(ByteSource& bytes) {
  constexpr double kResolutions[] = {0.05, 0.1, 0.05, 0.1, 0.2, 0.025, 0.001, 1, 10};
  constexpr double kOrigins[] = {0, -7.5, 3.14159, 0, 500000, -5.4e6, 1e7};
  GreyMap map;
  map.frame.width = 1 + int(bytes.below(64)), map.frame.height = 1 + int(bytes.below(64));
  map.frame.resolution = bytes.oneOf(kResolutions);
  map.frame.origin = {bytes.oneOf(kOrigins), bytes.oneOf(kOrigins)};
  map.source.file = "odd", map.source.kind = "image";
  map.grey.assign(map.frame.cellCount(), kFree);
  switch (bytes.below(4)) {
    case 0:
      noise(map.grey, bytes);
      break;
    case 1:
      pattern(map.grey, map.frame, bytes);
      break;
    default:
      strokes(map.grey, map.frame, bytes);
  }
  specks(map.grey, bytes);
  map.occupiedAbove = 0.65, map.freeBelow = 0.196;
  return map;
}

ExtractOptions oddOptions(ByteSource& bytes) {
  ExtractOptions options = preset(bytes.below(4) == 0 ? "paper" : "default");
  const FieldTable table = describe(options);
  for (unsigned changes = bytes.below(6); changes > 0; --changes) {
    const Field& field = table.fields()[bytes.below(unsigned(table.fields().size()))];
    const double share = bytes.below(65536) / 65535.0;
    if (auto* const* number = std::get_if<double*>(&field.value))
      // Most ranges are far wider than what is sensible: small numbers are tried more often.
      **number = field.low + (field.high - field.low) * std::pow(share, 4);
    if (auto* const* count = std::get_if<int*>(&field.value))
      **count = int(field.low + (field.high - field.low) * share);
    if (bool* const* isOn = std::get_if<bool*>(&field.value)) **isOn = share > 0.5;
    if (std::string* const* choice = std::get_if<std::string*>(&field.value))
      **choice = field.choices[std::size_t(share * double(field.choices.size() - 1))];
  }
  return options;
}

}  // namespace roomgraph::test
