#include "roomgraph/base/printable.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(Printable, leavesTextOfAllLanguagesAsItIs) {
  for (const char* text : {"", "office 1.yaml", "B\u00fcro", "\u4e8b\u52d9\u6240",
                           "\u05d1\u05d9\u05ea", "\U0001F3E0", "\u00a0~\u00ff\uffff\U0010FFFF"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, takesWhatSteersATerminalOut) {
  EXPECT_EQ(printable("a\x1b[31mb\r\nc\td\x7f"), "a?[31mb??c?d?");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a?b");
  EXPECT_EQ(printable("a\u009b31mb\u0080c\u0085"), "a?31mb?c?");
}

TEST(Printable, takesMarksThatHideOrTurnTextOut) {
  for (const char* mark : {"\u202e", "\u2066", "\u200f", "\u061c", "\u200b", "\u2028", "\ufeff"})
    EXPECT_EQ(printable(std::string("a") + mark + "b"), "a?b");
}

TEST(Printable, takesWhatIsNoUtf8Out) {
  EXPECT_EQ(printable("\x9b"), "?");                 // a control character of Latin 1
  EXPECT_EQ(printable("a\xc3"), "a?");               // cut short
  EXPECT_EQ(printable("\xc3(b"), "?(b");             // no second byte
  EXPECT_EQ(printable("\xc0\x9b"), "??");            // longer than need be
  EXPECT_EQ(printable("\xe0\x82\x9b"), "???");       // the same, U+009B in three bytes
  EXPECT_EQ(printable("\xed\xa0\x80"), "???");       // half of a pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "????");  // above the last one
  EXPECT_EQ(printable("\xff\xfe"), "??");
}

}  // namespace
}  // namespace roomgraph
