#include "roomgraph/mrpt_plugin/graph_text.h"

#include <gtest/gtest.h>

#include "sample_graph.h"

namespace roomgraph {
namespace {

using ::testing::AssertionResult;

AssertionResult holds(const std::string& text, const std::string& line) {
  if (("\n" + text).find("\n" + line + "\n") != std::string::npos)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "no line \"" << line << "\" in\n" << text;
}

TEST(GraphText, tellsMapCountsRoomsAndNotes) {
  const std::string text = graphText(sampleGraph().file);
  EXPECT_TRUE(holds(text, "Room graph of office.gridmap"));
  EXPECT_TRUE(holds(text,
                    "  map       240 x 160 cells of 0.1000 m, lower left corner at "
                    "(-12.00, -8.00) m"));
  EXPECT_TRUE(holds(text, "  sha256    " + std::string(64, 'a')));
  EXPECT_TRUE(holds(text, "15 vertices: 4 room, 5 border, 4 junction, 1 dead end, 1 ring"));
  EXPECT_TRUE(holds(text, "4 rooms of 251.88 m2"));
  EXPECT_TRUE(holds(text, "     2       80.20                  2.90      2  (-7.50, -4.00)"));
  EXPECT_TRUE(holds(text,
                    "  component_dropped: A part of the graph was dropped. "
                    "(at 1.50, 2.50)"));
}

TEST(GraphText, addsUpTheLengths) {
  const CRoomGraph sample = sampleGraph();
  double corridors = 0, inRooms = 0;
  for (const Edge& edge : sample.file.graph.graph.edges())
    (edge.room ? inRooms : corridors) += length(edge.path.points);
  char line[200];
  std::snprintf(line, sizeof line, "16 edges: 10 corridors of %.2f m, 6 inside of rooms of %.2f m",
                corridors, inRooms);
  EXPECT_TRUE(holds(graphText(sample.file), line));
  std::snprintf(line, sizeof line, "total path length %.2f m", corridors + inRooms);
  EXPECT_TRUE(holds(graphText(sample.file), line));
}

TEST(GraphText, anEmptyGraphHasAText) {
  const std::string text = graphText(GraphFile{});
  EXPECT_TRUE(holds(text, "0 vertices: 0 room, 0 border, 0 junction, 0 dead end, 0 ring"));
  EXPECT_TRUE(holds(text, "0 rooms of 0.00 m2"));
}

}  // namespace
}  // namespace roomgraph
