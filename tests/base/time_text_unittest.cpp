#include "roomgraph/base/time_text.h"

#include <gtest/gtest.h>

#include <ctime>

namespace roomgraph {
namespace {

TEST(TimeText, secondsHaveADayAndATime) {
  EXPECT_EQ(timeText(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(timeText(1795313100.75), "2026-11-22T02:05:00Z");
  EXPECT_EQ(timeText(-1), "1969-12-31T23:59:59Z");
  EXPECT_EQ(dayText(1795313100), "2026-11-22");
}

TEST(TimeText, whatIsNoTimeHasNoText) {
  EXPECT_EQ(timeText(1e15), "");
  EXPECT_EQ(timeText(-1e15), "");
  EXPECT_EQ(timeText(std::nan("")), "");
  EXPECT_EQ(dayText(1e300), "");
}

TEST(ParseTime, daysAndTimesAreRead) {
  EXPECT_EQ(parseTime("2026-11-22"), 1795305600.0);
  EXPECT_EQ(parseTime("2026-11-22T02:05"), 1795313100.0);
  EXPECT_EQ(parseTime("2026-11-22T02:05Z"), 1795313100.0);
  EXPECT_EQ(parseTime("2026-11-22T02:05:07"), 1795313107.0);
  EXPECT_EQ(parseTime("2026-11-22T02:05:07Z"), 1795313107.0);
  EXPECT_EQ(parseTime("1795313107.5"), 1795313107.5);
}

TEST(ParseTime, whatIsWrittenIsReadBack) {
  for (const double time : {0.0, 951782400.0, 1795313107.0, 4e9})
    EXPECT_EQ(parseTime(timeText(time)), time);
}

TEST(TimeText, whatIsADayAheadIsStillToCome) {
  const auto now = double(std::time(nullptr));
  EXPECT_FALSE(isToCome(now + 0.9 * kDay));
  EXPECT_TRUE(isToCome(now + 1.1 * kDay));
}

TEST(ParseTime, allElseIsNone) {
  for (const char* text :
       {"", "yesterday", "2026-02-31", "2026-13-01", "2026-11-22T25:00", "2026-11-22 02:05",
        "2026-11-22T02:05:07Zx", " 2026-11-22", "26-11-22", "2026-11-22x", "1e300", "nan"})
    EXPECT_FALSE(parseTime(text)) << text;
}

}  // namespace
}  // namespace roomgraph
