#include <gtest/gtest.h>

#include "View.h"
#include "sample_view.h"

namespace roomgraph {
namespace {

using test::viewOfMap;

TEST(ExtractAgain, takesTheOptionsOfTheView) {
  View view = viewOfMap();
  EXPECT_EQ(view.graph->file.graph.rooms.size(), 2u);
  view.options.findRooms.minWidth = 50;
  extractAgain(view);
  EXPECT_EQ(view.graph->file.graph.rooms.size(), 0u);
}

TEST(LoadView, whatIsMissingIsSaid) {
  EXPECT_ANY_THROW(loadView({"no such file.simplemap"}, {}, [](const std::string&) {}));
  EXPECT_ANY_THROW(loadView({"no such file.json"}, {}, [](const std::string&) {}));
}

}  // namespace
}  // namespace roomgraph
