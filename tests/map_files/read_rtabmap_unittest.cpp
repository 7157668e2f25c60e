#include <gtest/gtest.h>

#include "TestFolder.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "rtabmap_database.h"

namespace roomgraph {
namespace {

using test::kRtabmapAdmin;
using test::packedMatrix;
using test::rtabmapDatabase;
using test::sqlBlob;
using test::sqliteDatabase;

/** Two rows of three cells, the lower first: free, occupied, unknown; unknown, free, 30 %. */
std::string sample() {
  const signed char cells[] = {0, 100, -1, -1, 0, 30};
  return packedMatrix({reinterpret_cast<const char*>(cells), sizeof cells}, 2, 3);
}

class Rtabmap : public testing::Test {
 protected:
  GreyMap load(const std::string& bytes) const { return loadGrid(dir_.write("map", bytes), {}); }
  /** Empty where it can be read. */
  std::string errorOf(const std::string& bytes) const {
    return test::refusalOf([&] { load(bytes); });
  }
  void expectRefused(const std::string& bytes, const std::string& part) const {
    const std::string text = errorOf(bytes);
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.rfind(dir_ / "map" + ": ", 0), 0u) << text;
  }
  const TestFolder dir_;
};

TEST_F(Rtabmap, itsGridIsReadWithItsPlace) {
  const GreyMap map = load(rtabmapDatabase(sqlBlob(sample())));
  EXPECT_EQ(map.source.kind, "rtabmap");
  EXPECT_EQ(map.frame.width, 3);
  EXPECT_EQ(map.frame.height, 2);
  EXPECT_EQ(map.frame.resolution, 0.05);
  EXPECT_EQ(map.frame.origin.x, -1.5);
  EXPECT_EQ(map.frame.origin.y, 2);
  const std::vector<State> states = {State::free,    State::occupied, State::unknown,
                                     State::unknown, State::free,     State::unknown};
  EXPECT_EQ(binarize(map, {}).cells, states);
}

TEST_F(Rtabmap, compressedItIsReadToo) {
  const std::string bytes = rtabmapDatabase(sqlBlob(sample()));
  EXPECT_EQ(load(test::gzipped(bytes)).grey, load(bytes).grey);
}

TEST_F(Rtabmap, withoutAGridSaysHowToGetOne) {
  expectRefused(rtabmapDatabase("NULL"), "has no 2D grid");
  expectRefused(sqliteDatabase(kRtabmapAdmin), "has no 2D grid");
}

TEST_F(Rtabmap, databasesOfOthersAreRefused) {
  expectRefused(sqliteDatabase("CREATE TABLE runs (id INTEGER);"), "none of rtabmap");
  expectRefused(sqliteDatabase("CREATE TABLE Admin (version TEXT, opt_map BLOB);"),
                "none of rtabmap");
}

/** What another program's file asks SQLite to compute is not computed. */
TEST_F(Rtabmap, viewsAreNotBelieved) {
  expectRefused(
      sqliteDatabase(
          "CREATE VIEW Admin AS WITH RECURSIVE t(n) AS (SELECT 1 UNION ALL SELECT n+1 FROM t) "
          "SELECT count(*) AS opt_map, 0 AS opt_map_x_min, 0 AS opt_map_y_min, 1 AS "
          "opt_map_resolution FROM t;"),
      "rtabmap");
}

TEST_F(Rtabmap, absurdGridsAreRefused) {
  const std::string cells(6, '\0');
  expectRefused(rtabmapDatabase(sqlBlob(packedMatrix(cells, 3, 3))), "damaged");
  expectRefused(rtabmapDatabase(sqlBlob(packedMatrix(cells, 2, 2))), "damaged");
  expectRefused(rtabmapDatabase(sqlBlob(packedMatrix(cells, -2, -3))), "damaged");
  expectRefused(rtabmapDatabase(sqlBlob(packedMatrix(cells, 20'000, 20'000))), "damaged");
  std::string followed = packedMatrix(cells, 2, 3);
  followed.insert(followed.size() - 12, "x");  // between the cells and how many they are
  expectRefused(rtabmapDatabase(sqlBlob(followed)), "damaged");
  expectRefused(rtabmapDatabase(sqlBlob(packedMatrix(cells, 2, 3, 5))),
                "damaged");  // 32-bit floats
  expectRefused(rtabmapDatabase(sqlBlob(packedMatrix(cells, 100'000, 100'000))), "400 million");
  expectRefused(rtabmapDatabase(sqlBlob(sample().substr(0, 12))), "damaged");
  expectRefused(rtabmapDatabase(sqlBlob(sample() + '\0')), "damaged");
  expectRefused(rtabmapDatabase("'text'"), "damaged");
  expectRefused(rtabmapDatabase(sqlBlob(sample()), "0, 0, 0"), "resolution");
  expectRefused(rtabmapDatabase(sqlBlob(sample()), "0, 0, NULL"), "resolution");
  expectRefused(rtabmapDatabase(sqlBlob(sample()), "1e300, 0, 0.05"), "resolution");
}

TEST_F(Rtabmap, damagedFilesAreReadOrRefusedInOneLine) {
  const std::string bytes = rtabmapDatabase(sqlBlob(sample()));
  int refused = 0;
  for (std::size_t size = 16; size < bytes.size(); size += 97)
    refused += errorOf(bytes.substr(0, size)).empty() ? 0 : 1;
  EXPECT_GT(refused, 0);
  refused = 0;
  for (std::size_t at = 16; at < bytes.size(); at += 5) {
    std::string odd = bytes;
    odd[at] = char(~odd[at]);
    const std::string text = errorOf(odd);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    refused += text.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace roomgraph
