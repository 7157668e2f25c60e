#include "read_place.h"

#include <gtest/gtest.h>

#include "sample_view.h"

namespace roomgraph {
namespace {

using test::sampleView;
using test::viewOfMap;

TEST(ReadState, measuresWhatWasClicked) {
  const View view = sampleView();
  ViewState state;
  changeMode(Mode::measure, view, state);
  state.corners = {{0, 0}, {3, 4}, {3, 5}};
  EXPECT_EQ(readState(view, state).back(), "measured: 6.00 m, the last piece 1.00 m");
}

TEST(ReadPlace, tellsRoomAndKeyFrame) {
  const View view = sampleView();
  ViewState state;
  state.run = 1;
  const auto lines = readPlace(view, state, {6.1, 1.2});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "(6.10, 1.20) m");
  EXPECT_EQ(lines[1], "room R1, 200.0 m2, in 1 of 2 runs; not in torn");
  EXPECT_EQ(lines[2],
            "key frame 12 at (6.00, 1.00), time 1000000012.00 (2001-09-09T01:46:52Z), "
            "error 0.10 m");
  EXPECT_EQ(readPlace(view, state, {50, 50}).size(), 1u);
}

TEST(ReadState, tellsTheBreak) {
  const View view = sampleView();
  ViewState state;
  lookAtFault(0, view, state);
  const auto lines = readState(view, state);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "torn");
  EXPECT_EQ(lines[2],
            "break 1 of 2: everything after it is turned by 11.5 degrees, shifted by 1.00 m");
}

TEST(ReadPlace, tellsRoomVertexAndPathOfTheOneMap) {
  const View view = viewOfMap();
  const auto room = view.graph->file.graph.rooms.at(0).center;
  const auto lines = readPlace(view, ViewState(), room);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].rfind("room 0, ", 0), 0u) << lines[1];
  EXPECT_EQ(lines[2].rfind("vertex ", 0), 0u) << lines[2];
  EXPECT_EQ(lines[3].rfind("path ", 0), 0u) << lines[3];
}

}  // namespace
}  // namespace roomgraph
