#include "roomgraph/mrpt_plugin/room_graph_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "TestFolder.h"
#include "map_files.h"
#include "object_bytes.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "sample_graph.h"

namespace roomgraph {
namespace {

class RoomGraphFile : public ::testing::Test {
 protected:
  void write(const std::string& bytes) const { folder_.write("sample.roomgraph", bytes); }

  /** The one line that tells why `bytes` are refused; empty if they are not. */
  std::string refusalOf(const std::string& bytes) const {
    write(bytes);
    const std::string line = test::refusalOf([&] { loadRoomGraph(path_); });
    if (!line.empty()) {
      EXPECT_EQ(line.rfind(path_, 0), 0U) << line;
      EXPECT_LT(line.size(), path_.size() + 120) << line;
      EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' '; })) << line;
    }
    return line;
  }

  const TestFolder folder_;
  const std::string path_ = folder_ / "sample.roomgraph";
};

TEST_F(RoomGraphFile, everythingComesBack) {
  const CRoomGraph sample = sampleGraph();
  write(roomGraphBytes(sample));
  const CRoomGraph back = loadRoomGraph(path_);
  EXPECT_EQ(back.file.program, "roomgraph");
  EXPECT_EQ(back.file.input.sha256, sample.file.input.sha256);
  EXPECT_EQ(back.file.input.frame.origin, sample.file.input.frame.origin);
  ASSERT_EQ(back.file.options.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(back.file.options[i].value, sample.file.options[i].value);
  ASSERT_EQ(back.file.graph.rooms.size(), 4U);
  EXPECT_EQ(back.file.graph.rooms[2].shape.polygon.holes,
            sample.file.graph.rooms[2].shape.polygon.holes);
  EXPECT_EQ(back.file.graph.rooms[3].borderVertices, sample.file.graph.rooms[3].borderVertices);
  const auto& edges = sample.file.graph.graph.edges();
  ASSERT_EQ(back.file.graph.graph.edges().size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Polyline &found = back.file.graph.graph.edges()[i].path.points,
                   &written = edges[i].path.points;
    ASSERT_EQ(found.size(), written.size());
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_LT(distance(found[k], written[k]), 1e-4);
    EXPECT_EQ(back.file.graph.graph.edges()[i].room, edges[i].room);
  }
  ASSERT_TRUE(back.map);
  EXPECT_EQ(back.map->cells, sample.map->cells);
  ASSERT_EQ(back.file.notes.size(), 2U);
  EXPECT_EQ(back.file.notes[0].where, sample.file.notes[0].where);
  EXPECT_FALSE(back.file.notes[1].where);
  EXPECT_EQ(roomGraphBytes(back), roomGraphBytes(sample));
}

TEST_F(RoomGraphFile, anEmptyGraphComesBack) {
  write(roomGraphBytes({}));
  const CRoomGraph back = loadRoomGraph(path_);
  EXPECT_TRUE(back.file.graph.graph.vertices().empty());
  EXPECT_FALSE(back.map);
}

TEST_F(RoomGraphFile, anUncompressedFileIsReadToo) {
  write(test::streamed(sampleGraph()));
  EXPECT_EQ(roomGraphBytes(loadRoomGraph(path_)), roomGraphBytes(sampleGraph()));
}

/** Whether the object's own bytes are refused, in one line. In memory: there are many of them. */
bool isRefused(const std::string& bytes) {
  const std::string line = test::refusalOf([&] {
    CRoomGraph graph;
    readGraphBytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "it",
                   graph);
  });
  EXPECT_EQ(line.find('\n'), std::string::npos);
  return !line.empty();
}

TEST(GraphBytes, areRefusedWhereverTheyAreCut) {
  const std::string whole = graphBytes(sampleGraph());
  ASSERT_FALSE(isRefused(whole));
  for (std::size_t end = 0; end < whole.size(); ++end)
    ASSERT_TRUE(isRefused(whole.substr(0, end))) << "the first " << end << " bytes";
  EXPECT_TRUE(isRefused(whole + "x"));
}

TEST(GraphBytes, anyByteMayBeWrongWithoutHarm) {
  const std::string whole = graphBytes(sampleGraph());
  std::size_t refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char wrong : {'\0', '\x7f', '\xff'}) {
      std::string damaged = whole;
      damaged[at] = wrong;
      refused += isRefused(damaged);  // or it is another graph that is as sound
    }
  EXPECT_GT(refused, whole.size() / 4);
}

TEST_F(RoomGraphFile, isRefusedWhereverItIsCut) {
  for (const std::string& whole : {test::streamed(sampleGraph()), roomGraphBytes(sampleGraph())})
    for (std::size_t end = 0; end < whole.size(); end += end < 40 ? 1 : 61)
      ASSERT_NE(refusalOf(whole.substr(0, end)), "") << "the first " << end << " bytes";
  const std::string whole = roomGraphBytes(sampleGraph());
  EXPECT_NE(refusalOf(whole.substr(0, whole.size() - 1)), "");
}

TEST_F(RoomGraphFile, noDamagedByteIsOverlookedByTheChecksum) {
  const std::string whole = roomGraphBytes(sampleGraph());
  // Bytes 3 to 9 of a gzip header say when and where it was made.
  for (std::size_t at = 10; at < whole.size(); at += 13) {
    std::string damaged = whole;
    damaged[at] = char(damaged[at] ^ 0x41);
    ASSERT_NE(refusalOf(damaged), "") << "byte " << at;
  }
}

TEST_F(RoomGraphFile, nothingMayFollow) {
  EXPECT_NE(refusalOf(roomGraphBytes(sampleGraph()) + "x"), "");
  EXPECT_NE(refusalOf(test::streamed(sampleGraph()) + "x"), "");
}

TEST_F(RoomGraphFile, otherFilesAreNoRoomGraph) {
  EXPECT_EQ(refusalOf("Hello, this is a letter, and no graph.\n"),
            path_ + ": is not a room graph: give a .roomgraph file");
  std::filesystem::remove(path_);
  EXPECT_THROW(loadRoomGraph(path_), DataError);
}

TEST_F(RoomGraphFile, wrongIdsAndNumbersAreRefused) {
  CRoomGraph wrongVertex = sampleGraph();
  wrongVertex.file.graph.rooms[1].borderVertices[0] = VertexId(15);
  EXPECT_NE(refusalOf(roomGraphBytes(wrongVertex)).find("border_vertices"), std::string::npos);

  CRoomGraph wrongPlace = sampleGraph();
  wrongPlace.file.graph.rooms[1].center.x = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusalOf(roomGraphBytes(wrongPlace)).find("center"), std::string::npos);

  CRoomGraph wrongFrame = sampleGraph();
  wrongFrame.map.reset();
  wrongFrame.file.input.frame.width = 65536;
  wrongFrame.file.input.frame.height = 65536;
  EXPECT_NE(refusalOf(roomGraphBytes(wrongFrame)).find("65536 x 65536"), std::string::npos);
}

TEST_F(RoomGraphFile, aMapOfAnotherSizeThanItsFrameIsNotWritten) {
  CRoomGraph graph = sampleGraph();
  graph.map->cells.pop_back();
  EXPECT_THROW(roomGraphBytes(graph), UsageError);
}

}  // namespace
}  // namespace roomgraph
