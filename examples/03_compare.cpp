// How two maps of one site lie in each other: 03_compare MAP MAP prints the pose of the second map
// in the first, how sure it is, and how far the two bend apart.
#include <cstdio>
#include <exception>

#include "roomgraph/grid/binarize.h"
#include "roomgraph/grid/load_grid.h"
#include "roomgraph/relate/relate_maps.h"

namespace {

roomgraph::MapForAlignment prepared(const char* file) {
  const roomgraph::GreyMap map = roomgraph::loadGrid(file, {});
  return roomgraph::mapForAlignment(roomgraph::binarize(map, {}), {});
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 3) return std::fprintf(stderr, "usage: 03_compare MAP MAP\n"), 2;
  const roomgraph::MapForAlignment a = prepared(arguments[1]), b = prepared(arguments[2]);

  const roomgraph::MapPair pair = roomgraph::relateMaps(a, b);

  const roomgraph::Alignment& found = pair.alignment;
  if (!found.isSameSite) return std::printf("not of the same site\n"), 0;
  std::printf("pose of the second in the first: %.2f m, %.2f m, %.1f degrees\n", found.pose.x,
              found.pose.y, found.pose.phi * 180 / 3.14159265);
  std::printf("probability that it is right: %.2f\n", found.confidence);
  std::printf("bend: %.2f m, over %.0f %% of the walls\n", pair.bInA.bend, 100 * pair.bInA.share);
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
