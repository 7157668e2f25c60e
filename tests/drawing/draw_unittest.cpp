#include "roomgraph/drawing/draw.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>
#include <thread>

#include "png_pixels.h"
#include "render.h"
#include "sample_stages.h"

namespace roomgraph {
namespace {

TEST(Draw, thePngShowsMapRoomsAndEveryKindOfVertex) {
  const Pixels pixels = decodePng(drawPng(sampleStages()));
  EXPECT_GT(pixels.countOf(58, 62, 68), 500) << "walls";
  EXPECT_GT(pixels.countOf(198, 203, 211), 500) << "unknown";
  EXPECT_GT(pixels.countOf(0, 114, 178), 50) << "corridors and junctions";
  EXPECT_GT(pixels.countOf(213, 94, 0), 10) << "dead end";
  EXPECT_GT(pixels.countOf(240, 228, 66), 10) << "border vertices";
  // Sky blue at 34 % on white.
  EXPECT_GT(
      pixels.countOf(198, 229, 248) + pixels.countOf(197, 229, 247) + pixels.countOf(198, 230, 248),
      5000)
      << "first room";
}

TEST(Draw, thePngShowsPassagesAndClutter) {
  Stages stages = sampleStages();
  stages.result = {};
  const Pixels all = decodePng(drawPng(stages));
  stages.areas = {};
  const Pixels withoutPassages = decodePng(drawPng(stages));
  stages.cleared = {};
  const Pixels plain = decodePng(drawPng(stages));
  EXPECT_GT(all.countOf(230, 159, 0), 100);
  EXPECT_EQ(withoutPassages.countOf(230, 159, 0), 0);
  const auto coloured = [](const Pixels& pixels) {
    int count = 0;
    for (std::size_t i = 0; i < pixels.rgb.size(); i += 3)
      count += pixels.rgb[i] > pixels.rgb[i + 1] + 15;
    return count;
  };
  EXPECT_GT(coloured(withoutPassages), 50);
  EXPECT_EQ(coloured(plain), 0);
}

TEST(Draw, aPictureWithoutAGraphHasNoColour) {
  Stages stages = sampleStages();
  stages.result = {};
  stages.areas = {};
  stages.cleared = {};
  const Pixels pixels = decodePng(drawPng(stages));
  EXPECT_EQ(pixels.countOf(0, 114, 178), 0);
  EXPECT_EQ(pixels.countOf(240, 228, 66), 0);
}

TEST(Draw, theSvgIsXmlOfTheSameSizeWithTheMapInIt) {
  const Stages stages = sampleStages();
  std::istringstream svg(drawSvg(stages));
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(svg, tree);
  const Pixels pixels = decodePng(drawPng(stages));
  EXPECT_EQ(tree.get<std::string>("svg.<xmlattr>.width"), std::to_string(pixels.width) + "px");
  EXPECT_EQ(tree.get<std::string>("svg.<xmlattr>.height"), std::to_string(pixels.height) + "px");
  EXPECT_NE(svg.str().find("data:image/png;base64,"), std::string::npos);
}

TEST(Draw, theSameStagesGiveTheSameBytes) {
  const Stages stages = extractedStages();
  const std::string png = drawPng(stages), svg = drawSvg(stages);
  EXPECT_EQ(drawPng(stages), png);
  EXPECT_EQ(drawSvg(stages), svg);
}

TEST(Draw, threadsDoNotDisturbEachOther) {
  const Stages stages = sampleStages();
  const std::string png = drawPng(stages), svg = drawSvg(stages);
  std::vector<std::string> results(8);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < results.size(); ++t)
    threads.emplace_back([&, t] { results[t] = t % 2 ? drawPng(stages) : drawSvg(stages); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < results.size(); ++t) EXPECT_EQ(results[t], t % 2 ? png : svg);
}

TEST(Draw, oddNamesDoNotSpoilThePicture) {
  Stages stages = sampleStages();
  const Pixels plain = decodePng(drawPng(stages));
  for (const char* name : {"caf\xe9.png", "\xf0\x9f", "tab\tand\nline", "", "<&>.png"}) {
    stages.source.file = name;
    const Pixels odd = decodePng(drawPng(stages));
    EXPECT_EQ(odd.countOf(0, 114, 178), plain.countOf(0, 114, 178)) << name;
    std::istringstream svg(drawSvg(stages));
    boost::property_tree::ptree tree;
    EXPECT_NO_THROW(boost::property_tree::read_xml(svg, tree)) << name;
  }
  stages.source.file = std::string(5000, 'W');
  EXPECT_EQ(decodePng(drawPng(stages)).width, plain.width);
}

TEST(Draw, oneCellIsEnough) {
  Stages stages;
  stages.grid = {{1, 1, 0.05, {}}, {State::unknown}};
  EXPECT_GT(decodePng(drawPng(stages)).width, 0);
  EXPECT_FALSE(drawSvg(stages).empty());
}

TEST(SvgBytes, idsAreNumberedInTheirOrder) {
  EXPECT_EQ(finishedSvg("<image id=\"image17\"/><use href=\"#image17\"/><g id=\"surface4\"/>"),
            "<image image-rendering=\"optimizeSpeed\" id=\"image1\"/><use href=\"#image1\"/>"
            "<g id=\"surface2\"/>");
  EXPECT_EQ(finishedSvg("<g/>"), "<g/>");
}

}  // namespace
}  // namespace roomgraph
