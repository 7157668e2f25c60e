#include "roomgraph/archive/add_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "TestFolder.h"
#include "drawn_building.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/graph_files/ros_map.h"

namespace roomgraph {
namespace {

/** An archive, and maps of a building in its folder. */
struct Office {
  TestFolder folder;
  Archive archive{folder / "office.db", Archive::Access::orNew};
  AddRunOptions options;
  std::vector<std::string> missing;

  Office() {
    options.site = "office", options.robot = "anna", options.time = 1000;
    options.onMissing = [this](const HistoryRun& run) { missing.push_back(run.file); };
  }
  std::string map(const std::string& name, const Transform2D& pose, std::uint32_t seed = 1) const {
    return folder.write(name, mapPgm(test::drawnBuilding(seed, pose)));
  }
  AddedRun add(const std::string& file) { return addRun(archive, file, options); }
};

TEST(AddRun, runsOfOneSiteArePlacedAndKeptWithWhereTheyComeFrom) {
  Office office;
  const AddedRun first = office.add(office.map("a.pgm", {}));
  EXPECT_FALSE(first.wasKnown);
  office.options.robot = "berta", office.options.time = 2000;
  const AddedRun second = office.add(office.map("b.pgm", {3, 1, 0.5}));
  EXPECT_TRUE(second.isPlaced);
  EXPECT_TRUE(second.roomsFailed.empty());
  const std::vector<HistoryRun> runs = office.archive.runs("office");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].robot, "anna");
  EXPECT_EQ(runs[1].robot, "berta");
  EXPECT_EQ(runs[1].time, 2000);
  EXPECT_EQ(runs[1].file, office.folder / "b.pgm");
}

TEST(AddRun, theSameContentUnderAnotherNameIsKnown) {
  Office office;
  office.add(office.map("a.pgm", {}));
  const AddedRun again = office.add(office.map("copy.pgm", {}));
  EXPECT_TRUE(again.wasKnown);
  EXPECT_FALSE(again.score);
  EXPECT_EQ(office.archive.runs("office").size(), 1u);
}

TEST(AddRun, aRunOfAnotherBuildingIsKeptWithoutAPlace) {
  Office office;
  office.add(office.map("a.pgm", {}));
  office.add(office.map("b.pgm", {3, 1, 0.5}));
  const AddedRun other = office.add(office.map("lab.pgm", {}, 11));
  EXPECT_FALSE(other.isPlaced);
  EXPECT_FALSE(other.reason.empty());
  EXPECT_EQ(office.archive.runs("office").size(), 3u);
}

TEST(AddRun, runsWhoseFilesAreGoneAreNotComparedWith) {
  Office office;
  const std::string gone = office.map("gone.pgm", {});
  office.add(gone), office.add(office.map("other.pgm", {1, 1, 0}));
  std::filesystem::remove(gone);
  office.add(office.map("b.pgm", {3, 1, 0.5}));
  std::sort(office.missing.begin(), office.missing.end());
  EXPECT_EQ(office.missing, (std::vector<std::string>{gone}));
}

TEST(AddRun, aRunThatCameInTheMeantimeIsComparedWithToo) {
  Office office;
  const std::string gone = office.map("gone.pgm", {});
  office.add(gone);
  std::filesystem::remove(gone);
  bool isFirst = true;
  office.options.onMissing = [&](const HistoryRun&) {
    if (!std::exchange(isFirst, false)) return;
    Archive archive(office.folder / "office.db", Archive::Access::existing);
    addRun(archive, office.map("fast.pgm", {1, 2, 0.3}), office.options);
  };
  const AddedRun added = office.add(office.map("slow.pgm", {3, 1, 0.5}));
  EXPECT_TRUE(added.score) << added.reason;
  EXPECT_EQ(office.archive.runs("office").size(), 3u);
}

TEST(AddRun, aMapThatCannotBeUsedLeavesTheArchiveAsItWas) {
  Office office;
  office.add(office.map("a.pgm", {}));
  const std::string cut = office.folder.write("cut.pgm", "P5 90 90 255\n...");
  const std::string text = test::refusalOf([&] { office.add(cut); });
  EXPECT_EQ(text.rfind(cut, 0), 0u) << text;
  EXPECT_THROW(office.add(office.folder / "none.pgm"), DataError);
  EXPECT_EQ(office.archive.runs("office").size(), 1u);
}

TEST(AddRun, aCopyIsKeptWhereOneIsAskedFor) {
  Office office;
  office.options.kept = office.folder / "kept";
  office.add(office.map("a.pgm", {}));
  const std::string file = office.archive.runs("office").at(0).file;
  EXPECT_EQ(file.rfind(office.options.kept, 0), 0u) << file;
  EXPECT_EQ(readAll(file), readAll(office.folder / "a.pgm"));
}

}  // namespace
}  // namespace roomgraph
