#include <gtest/gtest.h>
#include <sqlite3.h>
#include <zlib.h>

#include <memory>

#include "map_files.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

using test::raw;

/** A matrix as rtabmap packs it. */
std::string packed(const std::string& cells, int rows, int columns, int type = 1) {
  std::string bytes(compressBound(cells.size()), '\0');
  uLongf size = bytes.size();
  compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
           reinterpret_cast<const Bytef*>(cells.data()), cells.size());
  bytes.resize(size);
  return bytes + raw(std::int32_t(rows)) + raw(std::int32_t(columns)) + raw(std::int32_t(type));
}

std::string hex(const std::string& bytes) {
  std::string text;
  for (const unsigned char byte : bytes)
    text += "0123456789abcdef"[byte >> 4], text += "0123456789abcdef"[byte & 15];
  return "x'" + text + "'";
}

/** The bytes of a database that the statements make. */
std::string database(const std::string& sql) {
  sqlite3* handle = nullptr;
  sqlite3_open(":memory:", &handle);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(
      sqlite3_serialize(handle, "main", &size, 0), sqlite3_free);
  std::string result(reinterpret_cast<const char*>(bytes.get()), std::size_t(size));
  sqlite3_close(handle);
  return result;
}

/** Those columns of rtabmap's table "Admin" that stand round the grid. */
constexpr const char* kAdmin =
    "CREATE TABLE Admin (version TEXT, preview_image BLOB, opt_map BLOB, opt_map_x_min FLOAT, "
    "opt_map_y_min FLOAT, opt_map_resolution FLOAT, time_enter DATE);";

std::string rtabmap(const std::string& grid, const std::string& place = "-1.5, 2, 0.05000000075") {
  return database(kAdmin + ("INSERT INTO Admin VALUES ('0.21.4', NULL, " + grid + ", " + place) +
                  ", NULL);");
}

/** Two rows of three cells, the lower first: free, occupied, unknown; unknown, free, 30 %. */
std::string sample() {
  const signed char cells[] = {0, 100, -1, -1, 0, 30};
  return packed({reinterpret_cast<const char*>(cells), sizeof cells}, 2, 3);
}

class Rtabmap : public testing::Test {
 protected:
  GreyMap load(const std::string& bytes) const { return loadGrid(dir_.write("map", bytes), {}); }
  /** Empty where it can be read. */
  std::string errorOf(const std::string& bytes) const {
    std::string text;
    try {
      load(bytes);
    } catch (const DataError& error) {
      text = error.what();
    }
    return text;
  }
  void expectRefused(const std::string& bytes, const std::string& part) const {
    const std::string text = errorOf(bytes);
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.rfind(dir_.path("map") + ": ", 0), 0u) << text;
  }
  const test::TempDir dir_;
};

TEST_F(Rtabmap, itsGridIsReadWithItsPlace) {
  const GreyMap map = load(rtabmap(hex(sample())));
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
  const std::string bytes = rtabmap(hex(sample()));
  EXPECT_EQ(load(test::gzipped(bytes)).grey, load(bytes).grey);
}

TEST_F(Rtabmap, withoutAGridSaysHowToGetOne) {
  expectRefused(rtabmap("NULL"), "has no 2D grid");
  expectRefused(database(kAdmin), "has no 2D grid");
}

TEST_F(Rtabmap, databasesOfOthersAreRefused) {
  expectRefused(database("CREATE TABLE runs (id INTEGER);"), "none of rtabmap");
  expectRefused(database("CREATE TABLE Admin (version TEXT, opt_map BLOB);"), "none of rtabmap");
}

/** What another program's file asks SQLite to compute is not computed. */
TEST_F(Rtabmap, viewsAreNotBelieved) {
  expectRefused(
      database("CREATE VIEW Admin AS WITH RECURSIVE t(n) AS (SELECT 1 UNION ALL SELECT n+1 FROM t) "
               "SELECT count(*) AS opt_map, 0 AS opt_map_x_min, 0 AS opt_map_y_min, 1 AS "
               "opt_map_resolution FROM t;"),
      "rtabmap");
}

TEST_F(Rtabmap, absurdGridsAreRefused) {
  const std::string cells(6, '\0');
  expectRefused(rtabmap(hex(packed(cells, 3, 3))), "damaged");
  expectRefused(rtabmap(hex(packed(cells, 2, 2))), "damaged");
  expectRefused(rtabmap(hex(packed(cells, -2, -3))), "damaged");
  expectRefused(rtabmap(hex(packed(cells, 2, 3, 5))), "damaged");  // 32-bit floats
  expectRefused(rtabmap(hex(packed(cells, 100'000, 100'000))), "400 million");
  expectRefused(rtabmap(hex(sample().substr(0, 12))), "damaged");
  expectRefused(rtabmap(hex(sample() + '\0')), "damaged");
  expectRefused(rtabmap("'text'"), "damaged");
  expectRefused(rtabmap(hex(sample()), "0, 0, 0"), "resolution");
  expectRefused(rtabmap(hex(sample()), "0, 0, NULL"), "resolution");
  expectRefused(rtabmap(hex(sample()), "1e300, 0, 0.05"), "resolution");
}

TEST_F(Rtabmap, damagedFilesAreReadOrRefusedInOneLine) {
  const std::string bytes = rtabmap(hex(sample()));
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
