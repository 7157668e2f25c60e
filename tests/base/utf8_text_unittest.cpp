#include "roomgraph/base/utf8_text.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(Utf8Text, whatIsUtf8StaysAsItIs) {
  for (const std::string text : {"", "plain", "caf\xc3\xa9 \"\\/\n", "\xef\xbf\xbd"})
    EXPECT_EQ(utf8Text(text), text);
}

TEST(Utf8Text, whatIsNotGetsAReplacementSign) {
  EXPECT_EQ(utf8Text("caf\xe9"), "caf\xef\xbf\xbd");
  EXPECT_EQ(utf8Text("\xe9.x"), "\xef\xbf\xbd.x");
}

}  // namespace
}  // namespace roomgraph
