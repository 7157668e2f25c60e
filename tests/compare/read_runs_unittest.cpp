#include <gtest/gtest.h>

#include <algorithm>

#include "TestFolder.h"
#include "drawn_building.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/compare/compare_maps.h"
#include "roomgraph/graph_files/ros_map.h"

namespace roomgraph {
namespace {

using test::drawnBuilding;

/** Pictures of maps in a folder, and what is told on reading them. */
struct Maps {
  TestFolder folder;
  CompareMapsOptions options;
  std::vector<std::string> unread, noted;

  Maps() {
    options.onUnread = [this](const LeftOutRun& run) { unread.push_back(run.name); };
    options.onNote = [this](const std::string& file, const Note&) { noted.push_back(file); };
  }
  std::string add(const std::string& name, const std::string& bytes) const {
    return folder.write(name, bytes);
  }
  std::string building(const std::string& name, const Transform2D& pose) const {
    return add(name, mapPgm(drawnBuilding(1, pose)));
  }
};

std::vector<std::string> namesOf(const ReadRuns& read) {
  std::vector<std::string> names;
  for (const roomgraph::Run& run : read.runs) names.push_back(run.name);
  std::sort(names.begin(), names.end());
  return names;
}

TEST(ReadRuns, whatCannotBeReadIsLeftOutAndTheRestIsUsed) {
  Maps maps;
  const std::string a = maps.building("a.pgm", {}), b = maps.building("b.pgm", {1, 2, 0.3});
  const std::string cut = maps.add("cut.pgm", "P5 90 90 255\n...");
  const std::string empty = maps.add("empty.pgm", "P5 3 1 255\n\xfe\xfe\xfe");
  const ReadRuns read = readRuns({a, cut, b, maps.folder / "none.pgm", empty}, maps.options);
  EXPECT_EQ(namesOf(read), (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(read.leftOut.size(), 3u);
  EXPECT_EQ(read.leftOut[0].name, "cut") << "by name";
  EXPECT_EQ(read.leftOut[1].reason, "has no wall beside free space: a run must have some");
  EXPECT_EQ(read.leftOut[2].reason.find("none.pgm"), std::string::npos) << "its file is told apart";
  EXPECT_EQ(maps.unread, (std::vector<std::string>{"cut", "none", "empty"}))
      << "as they were given";
  EXPECT_EQ(maps.noted, (std::vector<std::string>{a, b})) << "a picture does not say its scale";
  EXPECT_FALSE(read.reference);
}

TEST(ReadRun, givesTheRunOrSaysWhyThereIsNone) {
  Maps maps;
  EXPECT_EQ(readRun(maps.building("a.pgm", {}), maps.options).name, "a");
  const std::string empty = maps.add("empty.pgm", "P5 3 1 255\n\xfe\xfe\xfe");
  EXPECT_EQ(test::refusalOf([&] { readRun(empty, maps.options); }),
            empty + ": has no wall beside free space: a run must have some");
}

TEST(ReadRuns, theOrderOfTheFilesChangesNothing) {
  Maps maps;
  const std::string a = maps.building("a.pgm", {}), b = maps.building("b.pgm", {1, 2, 0.3}),
                    c = maps.building("c.pgm", {-3, 0, 1});
  const ReadRuns one = readRuns({a, b, c}, maps.options), other = readRuns({c, a, b}, maps.options);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(one.runs[i].name, other.runs[i].name) << i;
}

TEST(ReadRuns, theReferenceIsFoundAmongTheRuns) {
  Maps maps;
  const std::string a = maps.building("a.pgm", {}), plan = maps.building("plan.pgm", {1, 2, 0.3});
  maps.options.reference = plan;
  const ReadRuns read = readRuns({a}, maps.options);
  ASSERT_TRUE(read.reference);
  EXPECT_EQ(read.runs[*read.reference].name, "plan");
}

TEST(ReadRuns, withoutItsReferenceNothingIsCompared) {
  Maps maps;
  const std::string a = maps.building("a.pgm", {});
  maps.options.reference = maps.folder / "none.pgm";
  EXPECT_THROW(readRuns({a}, maps.options), DataError);
}

TEST(ReadRuns, ofNoMapAtAllTheFilesAreNamed) {
  Maps maps;
  const std::string none = maps.folder / "none.pgm";
  EXPECT_EQ(test::refusalOf([&] { readRuns({none}, maps.options); }),
            "no map could be used (" + none + ": there is no such file: check the name)");
  EXPECT_THROW(readRuns({}, maps.options), DataError);
}

TEST(ReadRuns, scalesAreEstimatedOfPicturesOnly) {
  Maps maps;
  maps.options.estimatesScale = true;
  const std::string yaml = maps.add("a.yaml",
                                    "image: a.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"
                                    "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string picture = maps.building("a.pgm", {});
  EXPECT_THROW(readRuns({yaml, yaml}, maps.options), UsageError) << "no map is a picture";
  EXPECT_EQ(readRuns({picture, yaml}, maps.options).runs.size(), 2u);
}

TEST(ReadRuns, aPictureIsReadAtTheScaleOfTheOthers) {
  Maps maps;
  maps.options.estimatesScale = true;
  maps.building("a.pgm", {});
  const std::string yaml = maps.add("a.yaml",
                                    "image: a.pgm\nresolution: 0.08\norigin: [0, 0, 0]\n"
                                    "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const ReadRuns read = readRuns({yaml, maps.building("plan.pgm", {1, 2, 0.3})}, maps.options);
  ASSERT_EQ(read.runs.size(), 2u);
  for (const roomgraph::Run& run : read.runs) {
    EXPECT_NEAR(run.resolution, 0.08, 0.001) << run.name;
    EXPECT_EQ(run.isScaleEstimated, run.name == "plan");
  }
}

TEST(ReadRuns, whereNoMapTellsAScaleAllPicturesShareOneThatIsUsual) {
  Maps maps;
  const std::string a = maps.building("a.pgm", {}), b = maps.building("b.pgm", {1, 2, 0.3});
  std::vector<std::string> codes;
  maps.options.onNote = [&](const std::string&, const Note& note) { codes.push_back(note.code); };
  std::vector<double> scales;
  for (const bool isAsked : {false, true}) {
    maps.options.estimatesScale = isAsked;
    for (const roomgraph::Run& run : readRuns({a, b}, maps.options).runs) {
      EXPECT_TRUE(run.isScaleEstimated);
      scales.push_back(run.resolution);
    }
  }
  EXPECT_EQ(codes, std::vector<std::string>(4, "usual_scale"));
  for (const double scale : scales) EXPECT_EQ(scale, scales[0]);
  EXPECT_GT(scales[0], 0.02);  // drawn at 0.05
  EXPECT_LT(scales[0], 0.1);
}

TEST(ReadRuns, aScaleThatIsGivenOrToldByAMapStays) {
  Maps maps;
  const std::string a = maps.building("a.pgm", {}), b = maps.building("b.pgm", {1, 2, 0.3});
  maps.options.extract.loadGrid.isResolutionGiven = true;
  for (const roomgraph::Run& run : readRuns({a, b}, maps.options).runs) {
    EXPECT_FALSE(run.isScaleEstimated);
    EXPECT_EQ(run.resolution, 0.05);
  }
  maps.options.extract.loadGrid.isResolutionGiven = false;
  const std::string yaml =
      maps.add("c.yaml", "image: a.pgm\nresolution: 0.07\norigin: [0, 0, 0]\n");
  const std::vector<roomgraph::Run> runs = readRuns({yaml, b}, maps.options).runs;
  ASSERT_EQ(runs.size(), 2u);
  for (const roomgraph::Run& run : runs) {
    EXPECT_FALSE(run.isScaleEstimated);
    EXPECT_EQ(run.resolution, run.name == "c" ? 0.07 : 0.05);
  }
}

TEST(ReadRuns, alignedMapsHaveAScale) {
  CompareMapsOptions options;
  options.compare.areAligned = options.estimatesScale = true;
  EXPECT_THROW(readRuns({"a.png", "b.png"}, options), UsageError);
}

}  // namespace
}  // namespace roomgraph
