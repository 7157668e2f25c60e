#include "make_office.h"

#include <algorithm>
#include <string>
#include <vector>

#include "FloorPlan.h"
#include "Random.h"
#include "roomgraph/base/Error.h"
#include "roughen_walls.h"

namespace roomgraph {
namespace {

// All lengths in cells of 0.05 m.
constexpr double kResolution = 0.05;
constexpr int kLeastSize = 400;
constexpr int kMargin = 20;
constexpr int kOuterWall = 4;
constexpr int kCorridor = 40;
constexpr int kNarrowest = 50, kWidest = 140;  // rooms
constexpr int kNarrowDoor = 16, kWideDoor = 20;
constexpr int kBlockWidth = 560, kBandHeight = 270;  // what they are near to

struct Span {
  int low = 0, high = 0;

  int length() const { return high - low; }
};

/** Divides a span into `count` parts of about equal length with `gap` between them. */
std::vector<Span> divide(Span span, int count, int gap) {
  std::vector<Span> parts;
  const int length = span.length() + gap;
  for (int i = 0; i < count; ++i)
    parts.push_back({span.low + length * i / count, span.low + length * (i + 1) / count - gap});
  return parts;
}

class Builder {
 public:
  explicit Builder(const MakeOfficeOptions& options)
      : options_(options),
        random_(options.seed),
        plan_(options.width, options.height, kResolution) {}

  GreyMap run() {
    const Span acrossX{kMargin, options_.width - kMargin};
    const Span acrossY{kMargin, options_.height - kMargin};
    plan_.fill({acrossX.low, acrossY.low, acrossX.high, acrossY.high}, grey::kWall);
    const Span insideX{acrossX.low + kOuterWall, acrossX.high - kOuterWall};
    const Span insideY{acrossY.low + kOuterWall, acrossY.high - kOuterWall};

    const int bands = std::max(1, (insideY.length() + kBandHeight / 2) / kBandHeight);
    const int leastBlocks = bands > 1 ? 2 : 1;  // else nothing would join the bands
    const int blocks = std::max(leastBlocks, (insideX.length() + kBlockWidth / 2) / kBlockWidth);
    const auto blockSpans = divide(insideX, blocks, kCorridor);
    for (std::size_t i = 1; i < blockSpans.size(); ++i)
      plan_.fill({blockSpans[i - 1].high, insideY.low, blockSpans[i].low, insideY.high},
                 grey::kFree);
    for (const Span band : divide(insideY, bands, random_.between(3, 4)))
      addBand(band, insideX, blockSpans);
    GreyMap map = std::move(plan_).take();
    if (!options_.isPlain) roughenWalls(map, {50, 50, options_.seed});
    return map;
  }

 private:
  /** A corridor with a row of rooms on either side in every block. */
  void addBand(Span band, Span insideX, const std::vector<Span>& blocks) {
    const int wall = random_.between(3, 4);
    const int rooms = band.length() - kCorridor - 2 * wall;
    const int lower = rooms * random_.between(42, 58) / 100;
    const Span corridor{band.low + lower + wall, band.low + lower + wall + kCorridor};
    plan_.fill({insideX.low, corridor.low, insideX.high, corridor.high}, grey::kFree);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      // Rooms end one wall before the corridors on either side of the block.
      const Span row{blocks[i].low + (i > 0 ? wall : 0),
                     blocks[i].high - (i + 1 < blocks.size() ? wall : 0)};
      addRow(row, {band.low, corridor.low - wall}, {corridor.low - wall, corridor.low}, true);
      addRow(row, {corridor.high + wall, band.high}, {corridor.high, corridor.high + wall}, false);
    }
  }

  /** Rooms side by side; `front` is the wall to their corridor. */
  void addRow(Span row, Span depth, Span front, bool isFrontAbove) {
    for (int x = row.low; x < row.high;) {
      const int wall = random_.between(3, 4);
      const int left = row.high - x;
      int width = std::min(random_.between(kNarrowest, kWidest), left);
      if (left - width - wall < kNarrowest)  // no room fits behind this one
        width = left <= kWidest ? left : left - wall - kNarrowest;
      const CellBox room{x, depth.low, x + width, depth.high};
      const bool hasNext = room.x1 + wall < row.high;
      addRoom(room, front, isFrontAbove);
      if (hasNext && random_.oneIn(6)) addDoorToNext(room, wall);
      x += width + wall;
    }
  }

  void addRoom(CellBox room, Span front, bool isFrontAbove) {
    if (random_.oneIn(20)) {  // nobody entered it
      plan_.fill(room, grey::kUnknown);
      return;
    }
    plan_.fill(room, grey::kFree);
    addDoor(room, front);
    if (room.width() > 110 && random_.oneIn(3)) addDoor(room, front);
    if (!options_.isPlain) furnish(room, isFrontAbove);
  }

  void addDoor(CellBox room, Span front) {
    const int width = random_.between(kNarrowDoor, kWideDoor);
    const int x = random_.between(room.x0 + 4, room.x1 - 4 - width);
    plan_.fill({x, front.low, x + width, front.high}, grey::kFree);
  }

  void addDoorToNext(CellBox room, int wall) {
    const int width = random_.between(kNarrowDoor, kWideDoor);
    const int y = random_.between(room.y0 + 4, room.y1 - 4 - width);
    plan_.fill({room.x1, y, room.x1 + wall, y + width}, grey::kFree);
  }

  /** Desks at the back wall, chairs before them, here and there a pillar. */
  void furnish(CellBox room, bool isFrontAbove) {
    int x = room.x0 + random_.between(0, 10);
    while (x + 24 < room.x1) {
      const int width = std::min(random_.between(24, 32), room.x1 - x);
      const int depth = random_.between(12, 16);
      const int back = isFrontAbove ? room.y0 : room.y1 - depth;
      if (!random_.oneIn(3)) {
        plan_.putFurniture({x, back, x + width, back + depth});
        const int chairX = x + random_.between(4, width - 8);
        const int chairY = isFrontAbove ? back + depth + 5 : back - 9;
        plan_.fill({chairX, chairY, chairX + 2, chairY + 2}, grey::kWall);
      }
      x += width + random_.between(0, 30);
    }
    if (room.width() > 100 && room.height() > 80 && random_.oneIn(3)) {
      const int px = (room.x0 + room.x1) / 2 - 4, py = (room.y0 + room.y1) / 2 - 4;
      plan_.fill({px, py, px + 8, py + 8}, grey::kWall);
    }
  }

  const MakeOfficeOptions& options_;
  Random random_;
  FloorPlan plan_;
};

}  // namespace

GreyMap makeOffice(const MakeOfficeOptions& options) {
  if (std::min(options.width, options.height) < kLeastSize)
    throw UsageError("an office of " + std::to_string(options.width) + " x " +
                     std::to_string(options.height) + " cells is too small: use at least " +
                     std::to_string(kLeastSize) + " cells each way");
  return Builder(options).run();
}

}  // namespace roomgraph
