#include "terminal.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

const std::vector<MapNote> kNotes{{"a.simplemap", {"slice", "is cut"}},
                                  {"a.simplemap", {"other_folder", "is of b", {}, true}},
                                  {"a.simplemap", {"size", "is large"}},
                                  {"c.simplemap", {"other_folder", "is of d", {}, true}}};

TEST(Terminal, ofTheNotesOnAMapTheFirstIsToldAndHowManyMoreThereAre) {
  EXPECT_EQ(noteLines({kNotes[0], kNotes[2]}, false),
            "roomgraph: a.simplemap: note: is cut (and 1 more note: see --verbose)\n");
  EXPECT_EQ(noteLines({kNotes[0], kNotes[2]}, true),
            "roomgraph: a.simplemap: note: is cut\nroomgraph: a.simplemap: note: is large\n");
}

TEST(Terminal, eachWarningIsToldEvenWhereNotesAreNot) {
  const std::string warnings =
      "roomgraph: a.simplemap: note: is of b\nroomgraph: c.simplemap: note: is of d\n";
  EXPECT_EQ(warningLines(kNotes), warnings);
  EXPECT_EQ(noteLines(kNotes, false),
            warnings + "roomgraph: a.simplemap: note: is cut (and 1 more note: see --verbose)\n");
  EXPECT_EQ(noteLines({kNotes[1]}, false), warningLines({kNotes[1]}));
}

}  // namespace
}  // namespace roomgraph
