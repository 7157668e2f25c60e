#include "base64.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(Base64, isThatOfTheStandard) {
  // The examples of RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, takesAnyByte) { EXPECT_EQ(base64(std::string("\xff\xef\0\x80", 4)), "/+8AgA=="); }

}  // namespace
}  // namespace roomgraph
