#include "roomgraph/base/Error.h"

#include <gtest/gtest.h>

#include "refusal.h"

namespace roomgraph {
namespace {

std::string refusal(const std::string& file, const std::string& problem) {
  return test::refusalOf([&] { refuse(file, problem, "choose another"); });
}

TEST(Refuse, tellsFileProblemAndRemedy) {
  EXPECT_EQ(refusal("a.png", "it is no map"), "a.png: it is no map: choose another");
}

TEST(Refuse, aFileWithoutANameIsStillNamed) {
  EXPECT_EQ(refusal("", "it is no map"), "'': it is no map: choose another");
}

TEST(Refuse, isOneLineWhateverTheFileIsCalled) {
  EXPECT_EQ(refusal("a\nb\x1b[2J.png", "x"), "a?b?[2J.png: x: choose another");
}

TEST(OrNothing, isEmptyOrFalseWhereDataCannotBeUsed) {
  EXPECT_TRUE(orNothing([] { return true; }));
  EXPECT_FALSE(orNothing([]() -> bool { refuse("a.png", "x", "y"); }));
  EXPECT_THROW((void)orNothing([]() -> bool { throw UsageError("x"); }), UsageError);
}

}  // namespace
}  // namespace roomgraph
