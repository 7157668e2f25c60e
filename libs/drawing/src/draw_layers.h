#pragma once
#include <functional>

#include "Scene.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/obstacle_cells.h"
#include "roomgraph/pipeline/Stages.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"
#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

/** A colour for each room, such that rooms near to each other differ as long as there are colours
 *  left. Depends on the order of the rooms. O(n^2) in the number of rooms, but quick. */
std::vector<Colour> roomColours(const std::vector<const Polygon*>& rooms);

/** Each layer is drawn over the ones before it. */
void drawRooms(const Pen& pen, const std::vector<const Polygon*>& rooms);
/** Ways inside of rooms thin and dashed below, corridors on top of them. */
void drawPaths(const Pen& pen, const TopologyGraph& graph);
/** The marks of all kinds but those of rooms, which drawRoomLabels() draws. */
void drawVertices(const Pen& pen, const TopologyGraph& graph);
/** The id of each room on a disc where its vertex stands. */
void drawRoomLabels(const Pen& pen, const std::vector<GraphRoom>& rooms);
void drawObstacles(const Pen& pen, const ObstacleCells& obstacles);
/** The finite edges that `isShown` picks by their index. */
void drawVoronoi(const Pen& pen, const VoronoiGraph& graph,
                 const std::function<bool(std::size_t)>& isShown, Colour colour);

/** What the layers above show, with counts; what does not occur is left out. */
std::vector<LegendItem> graphLegend(const TopologyGraph& graph);
LegendItem roomLegend(std::size_t count);
std::vector<LegendItem> stateLegend(const Grid& grid);
LegendItem lineLegend(const std::string& label, Colour colour, double widthPx);
LegendItem squareLegend(const std::string& label, Colour colour);

/** "1 room", "2 rooms", "3 vertices"; thousands are set apart. */
std::string groupedCount(std::size_t count, const std::string& one, const std::string& many);

/** A stroke across each opening. */
void drawPassages(const Pen& pen, const std::vector<Passage>& passages);
/** A disc over each obstacle that is taken for clutter. */
void drawClutter(const Pen& pen, const std::vector<Clutter>& clutter);

/** The picture of the result; `stages` must outlive it. */
Scene resultScene(const Stages& stages);

/** Passages and clutter, where there are any. */
std::vector<LegendItem> areaLegend(const Stages& stages);

/** "0.05 m per cell" */
std::string resolutionText(double metres);

}  // namespace roomgraph
