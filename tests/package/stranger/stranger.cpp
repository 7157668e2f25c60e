// Closes one room with walls and expects to get it back.
#include <roomgraph/pipeline/extract.h>

#include <cstdio>

int main() {
  roomgraph::GreyMap map;
  map.frame = {100, 80, 0.05, {-1, -2}};
  map.grey.assign(map.frame.cellCount(), 255);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x)
      if (x < 2 || y < 2 || x > 97 || y > 77) map.grey[map.frame.index({x, y})] = 0;

  const roomgraph::Stages stages = roomgraph::extract(map, roomgraph::ExtractOptions());
  std::printf("%zu rooms\n", stages.result.rooms.size());
  return stages.result.rooms.size() == 1 ? 0 : 1;
}
