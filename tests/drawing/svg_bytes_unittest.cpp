#include <gtest/gtest.h>

#include "render.h"

namespace roomgraph {
namespace {

TEST(FinishedSvg, numbersImagesAndSurfacesInTheirOrder) {
  EXPECT_EQ(
      finishedSvg("<g id=\"surface42\"><use xlink:href=\"#image17\"/></g><g id=\"surface42\"/>"),
      "<g id=\"surface1\"><use xlink:href=\"#image2\"/></g><g id=\"surface1\"/>");
}

TEST(FinishedSvg, isTheSameWhateverCairoHasCounted) {
  const auto svg = [](const std::string& first, const std::string& second) {
    return finishedSvg("<i id=\"image" + first + "\"/><i id=\"image" + second + "\"/><u \"#image" +
                       first + "\"/>");
  };
  EXPECT_EQ(svg("5", "6"), svg("105", "7"));
}

TEST(FinishedSvg, isTheSameWhateverCairoHasCountedSinceItsVersion118) {
  EXPECT_EQ(
      finishedSvg("<i id=\"source-72\"/><use xlink:href=\"#source-72\"/><use \"#glyph-0-7\"/>"),
      "<i id=\"source-1\"/><use xlink:href=\"#source-1\"/><use \"#glyph-0-7\"/>");
}

TEST(FinishedSvg, asksForSquareCells) {
  EXPECT_EQ(finishedSvg("<image width=\"3\"/>"),
            "<image image-rendering=\"optimizeSpeed\" width=\"3\"/>");
  EXPECT_EQ(finishedSvg("<svg/>"), "<svg/>");
}

}  // namespace
}  // namespace roomgraph
