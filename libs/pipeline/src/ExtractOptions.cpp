#include "roomgraph/pipeline/ExtractOptions.h"

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** The paper's numbers; where it gives none, those of its authors' code, in cells. */
ExtractOptions paperPreset() {
  ExtractOptions options;
  options.binarize.blackThreshold = 100;
  options.thinObstacles.neighbours = "8";
  options.thinObstacles.unknownIsObstacle = false;
  options.keepInside.outsideAlphaPx2 = 3600;
  options.keepInside.biggestOnly = true;
  options.keepInside.freeOnly = false;
  options.deadEnds.allOnce = true;
  options.deadEnds.minLengthPx = 8;
  options.joinVertices.maxDistancePx = 4;
  options.keepComponents.onlyLargest = true;
  options.clearClutter.maxSize = 0;
  options.findRooms.alphaPx2 = 250;
  options.shortDeadEnds.minLengthPx = 20;
  options.joinDoors.maxDepth = 0;
  options.roomGraph.straightEdges = true;
  return options;
}

}  // namespace

FieldTable describe(ExtractOptions& options) {
  FieldTable table;
  describe(options.loadGrid, table);
  describe(options.binarize, table);
  describe(options.thinObstacles, table);
  describe(options.keepInside, table);
  describe(options.keepClear, table);
  describe(options.deadEnds, table);
  describe(options.joinVertices, table);
  describe(options.keepComponents, table);
  describe(options.clearClutter, table);
  describe(options.findRooms, table);
  describe(options.splitAtDoors, table);
  describe(options.shortDeadEnds, table);
  describe(options.joinDoors, table);
  describe(options.roomGraph, table);
  return table;
}

ExtractOptions preset(const std::string& name) {
  if (name == "default") return {};
  if (name == "paper") return paperPreset();
  throw UsageError("there is no preset '" + name + "': use default or paper");
}

}  // namespace roomgraph
