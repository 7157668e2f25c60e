#include "roomgraph/base/xml_text.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(XmlText, holdsNoMarkupAndNoLineEnds) {
  EXPECT_EQ(xmlText("a <b> & \"c\""), "a &lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_EQ(xmlText("a\nb\x1b"), "a?b?");
  EXPECT_EQ(xmlText("é"), "é");
  EXPECT_EQ(xmlText(""), "");
}

}  // namespace
}  // namespace roomgraph
