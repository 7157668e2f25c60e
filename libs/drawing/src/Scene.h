#pragma once
#include <functional>
#include <string>
#include <vector>

#include "Pen.h"

namespace roomgraph {

struct LegendItem {
  std::string label;
  std::function<void(const Pen&, Point)> symbol;  ///< draws round a place [px], at most 18 px wide
};

/** What a picture shows on top of the map, and what is said about it. */
struct Scene {
  std::string title, subtitle;
  std::function<void(const Pen&)> layers;  ///< drawn in this order, clipped to the map
  std::vector<LegendItem> legend;
};

}  // namespace roomgraph
