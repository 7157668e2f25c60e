#pragma once
#include "Scene.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

/** Rooms and corridors filled alike. */
void drawAreas(const Pen& pen, const std::vector<Area>& areas);
/** A stroke across each opening. */
void drawPassages(const Pen& pen, const std::vector<Passage>& passages);
/** A disc over each obstacle that is taken for clutter. */
void drawClutter(const Pen& pen, const std::vector<Clutter>& clutter);

/** A corridor as drawAreas() shows it. */
LegendItem corridorAreaLegend(std::size_t count);
LegendItem passageLegend(std::size_t count);
LegendItem clutterLegend();

}  // namespace roomgraph
