#include "random_maps.h"

#include <algorithm>
#include <random>

namespace roomgraph::test {
namespace {

class Canvas {
 public:
  Canvas(int width, int height, double resolution) {
    map_ =
        drawn(std::vector<std::string>(std::size_t(height), std::string(std::size_t(width), '.')),
              resolution);
    fill(0, 0, width, 1, '#');
    fill(0, height - 1, width, 1, '#');
    fill(0, 0, 1, height, '#');
    fill(width - 1, 0, 1, height, '#');
  }

  /** Cells beyond the canvas are left out. */
  void fill(int x, int y, int width, int height, char cell) {
    for (int cy = std::max(0, y); cy < std::min(map_.height, y + height); ++cy)
      for (int cx = std::max(0, x); cx < std::min(map_.width, x + width); ++cx)
        map_.cells[std::size_t(cy) * std::size_t(map_.width) + std::size_t(cx)] = cell;
  }

  void paint(const Stroke& stroke) {
    const int x = 1 + int(stroke.x % unsigned(map_.width - 2));
    const int y = 1 + int(stroke.y % unsigned(map_.height - 2));
    const int width = 1 + int(stroke.width % 12), height = 1 + int(stroke.height % 12);
    switch (stroke.kind % 6) {
      case 0:
        return fill(x, y, 1, 3 * height, '#');
      case 1:
        return fill(x, y, 3 * width, 1, '#');
      case 2:
        return fill(x, y, width, height, '#');
      case 3:
        return inside(x, y, width, height, '?');
      case 4:
        return inside(x, y, width, height, '.');
      default:
        return fill(x, y, 1 + width % 2, 1 + height % 2, '#');
    }
  }

  MapText take() { return std::move(map_); }

 private:
  /** The wall round the map stays. */
  void inside(int x, int y, int width, int height, char cell) {
    fill(x, y, std::min(width, map_.width - 1 - x), std::min(height, map_.height - 1 - y), cell);
  }

  MapText map_;
};

}  // namespace

MapText painted(int width, int height, double resolution, const std::vector<Stroke>& strokes) {
  Canvas canvas(width, height, resolution);
  for (const Stroke& stroke : strokes) canvas.paint(stroke);
  return canvas.take();
}

MapText randomMap(std::uint32_t seed, int width, int height, double resolution) {
  // The engine's numbers are laid down by the standard; those of its distributions are not.
  std::mt19937 random(seed);
  std::vector<Stroke> strokes(4 + random() % 24);
  for (Stroke& s : strokes) {
    s.kind = unsigned(random());
    s.x = unsigned(random());
    s.y = unsigned(random());
    s.width = unsigned(random());
    s.height = unsigned(random());
  }
  return painted(width, height, resolution, strokes);
}

MapText noisyOffice(std::uint32_t seed, int side) {
  constexpr int room = 80, corridor = 24, wall = 2, door = 18;
  std::mt19937 random(seed);
  Canvas canvas(side, side, 0.05);
  for (int y = 0, row = 0; y < side; y += row % 2 ? room + corridor : room, ++row) {
    canvas.fill(0, y, side, wall, '#');
    if (row % 2) canvas.fill(0, y + corridor, side, wall, '#');
    for (int x = 0; x < side; x += room) {
      canvas.fill(x, row % 2 ? y + corridor : y, wall, room, '#');
      const int at = x + 10 + int(random() % 40);
      canvas.fill(at, row % 2 ? y + corridor : y, door, wall, '.');
      canvas.fill(at, y, door, wall, '.');
    }
  }
  canvas.fill(0, 0, side, 2, '#');
  canvas.fill(0, side - 2, side, 2, '#');
  MapText map = canvas.take();
  // Walls lose cells and floors get some, as laser maps show it.
  for (int i = 0; i < side * side / 60; ++i) {
    const int x = int(random() % unsigned(side)), y = int(random() % unsigned(side));
    char& cell = map.cells[std::size_t(y) * std::size_t(side) + std::size_t(x)];
    const bool nearWall =
        y > 0 && x > 0 &&
        (map.cells[std::size_t(y - 1) * std::size_t(side) + std::size_t(x)] == '#' ||
         map.cells[std::size_t(y) * std::size_t(side) + std::size_t(x - 1)] == '#');
    if (nearWall || random() % 40 == 0) cell = '#';
  }
  return map;
}

}  // namespace roomgraph::test
