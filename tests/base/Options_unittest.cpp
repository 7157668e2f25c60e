#include "roomgraph/base/Options.h"

#include <gtest/gtest.h>

#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/Ids.h"
#include "roomgraph/base/UnionFind.h"

namespace roomgraph {
namespace {

struct Settings {
  double width = 1.5;
  int count = 3;
  bool isOn = true;
  std::string mode = "fast";
};

FieldTable describe(Settings& settings) {
  FieldTable table;
  table.number("door", "width", settings.width, "m", 0.1, 10, "How wide.");
  table.count("door", "count", settings.count, 0, 9, "How many.");
  table.flag("wall", "is_on", settings.isOn, "Whether.");
  table.choice("wall", "mode", settings.mode, {"fast", "slow", "none"}, "Which.");
  return table;
}

/** Settings, and what sets them. */
struct Described : testing::Test {
  Settings settings;
  FieldTable table = describe(settings);
};

using OptionFields = Described;
using Ini = Described;

/** What the error says; empty where there is none. */
template <class Function>
std::string usageError(const Function& function) {
  return test::refusalOf<UsageError>(function);
}

std::string iniError(const std::string& text) {
  Settings settings;
  FieldTable table = describe(settings);
  return usageError([&] { fromIni(text, "my.ini", table); });
}

TEST_F(OptionFields, setsEveryKindOfField) {
  table.set("door", "width", "2.25");
  table.set("door", "count", "7");
  table.set("wall", "is_on", "off");
  table.set("wall", "mode", "slow");
  EXPECT_EQ(settings.width, 2.25);
  EXPECT_EQ(settings.count, 7);
  EXPECT_FALSE(settings.isOn);
  EXPECT_EQ(settings.mode, "slow");
}

TEST_F(OptionFields, namesSectionKeyValueAndRangeOfABadValue) {
  const std::string text = usageError([&] { table.set("door", "width", "11"); });
  for (const char* part : {"[door]", "width", "11", "0.1 to 10 m"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_EQ(settings.width, 1.5);
}

TEST_F(OptionFields, refusesWhatIsNoNumber) {
  for (const char* bad : {"", "nan", "inf", "1m", "1,5", "0x3", "two"})
    EXPECT_THROW(table.set("door", "width", bad), UsageError) << bad;
  for (const char* bad : {"", "1.5", "10", "-1", "99999999999999"})
    EXPECT_THROW(table.set("door", "count", bad), UsageError) << bad;
  EXPECT_THROW(table.set("wall", "is_on", "yes"), UsageError);
  EXPECT_THROW(table.set("wall", "mode", "Fast"), UsageError);
}

TEST_F(OptionFields, acceptsTheEndsOfTheRange) {
  EXPECT_NO_THROW(table.set("door", "width", "0.1"));
  EXPECT_NO_THROW(table.set("door", "width", "10"));
}

TEST_F(OptionFields, tellsAnUnknownSectionFromAnUnknownKey) {
  EXPECT_NE(usageError([&] { table.set("roof", "width", "1"); }).find("no section [roof]"),
            std::string::npos);
  EXPECT_NE(usageError([&] { table.set("door", "depth", "1"); }).find("no key 'depth'"),
            std::string::npos);
}

TEST_F(OptionFields, guessesWhatWasMeant) {
  EXPECT_EQ(usageError([&] { table.set("dor", "width", "1"); }),
            "there is no section [dor]: did you mean 'door'?");
  EXPECT_EQ(usageError([&] { table.set("door", "widht", "1"); }),
            "[door] has no key 'widht': did you mean 'width'?");
  EXPECT_EQ(usageError([&] { table.set("chimney", "width", "1"); }),
            "there is no section [chimney]: see 'roomgraph config'");
}

TEST_F(OptionFields, writesRangesForPeople) {
  EXPECT_EQ(rangeText(table.fields()[0]), "0.1 to 10 m");
  EXPECT_EQ(rangeText(table.fields()[1]), "0 to 9");
  EXPECT_EQ(rangeText(table.fields()[2]), "true or false");
  EXPECT_EQ(rangeText(table.fields()[3]), "fast, slow or none");
}

TEST_F(Ini, readsBackWhatItWrote) {
  Settings written;
  written.width = 0.1 + 0.2;
  written.isOn = false;
  written.mode = "none";
  fromIni(toIni(describe(written)), "x.ini", table);
  EXPECT_EQ(settings.width, written.width);
  EXPECT_EQ(settings.isOn, written.isOn);
  EXPECT_EQ(settings.mode, written.mode);
}

TEST_F(Ini, keepsWhatItDoesNotName) {
  fromIni("; a comment\n\n[door]\r\n  width=2 # as measured\n", "x.ini", table);
  EXPECT_EQ(settings.width, 2);
  EXPECT_EQ(settings.count, 3);
}

TEST_F(Ini, namesFileAndLineOfAnError) {
  EXPECT_EQ(iniError("[door]\nwidth 2\n").rfind("my.ini:2: ", 0), 0u);
  EXPECT_EQ(iniError("[door]\n\nwidth = 200\n").rfind("my.ini:3: ", 0), 0u);
  EXPECT_EQ(iniError("width = 2\n").rfind("my.ini:1: ", 0), 0u);
}

TEST_F(Ini, refusesAKeyThatIsSetTwice) {
  EXPECT_NE(iniError("[door]\nwidth = 2\n[wall]\n[door]\nwidth = 2\n").find("set twice"),
            std::string::npos);
}

TEST(UnionFind, namesAGroupByItsSmallestMember) {
  UnionFind groups(6);
  EXPECT_TRUE(groups.join(5, 3));
  EXPECT_TRUE(groups.join(4, 5));
  EXPECT_FALSE(groups.join(3, 4));
  EXPECT_EQ(groups.find(5), 3u);
  EXPECT_TRUE(groups.join(1, 4));
  EXPECT_EQ(groups.find(5), 1u);
  EXPECT_EQ(groups.find(0), 0u);
}

TEST(Ids, noneIsFalseAndSortsLast) {
  const RoomId none;
  EXPECT_TRUE(none.isNone());
  EXPECT_FALSE(none);
  EXPECT_TRUE(RoomId(0));
  EXPECT_LT(RoomId(7), none);
  EXPECT_EQ(none, RoomId::none());
}

}  // namespace
}  // namespace roomgraph
