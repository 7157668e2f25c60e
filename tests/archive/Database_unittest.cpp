#include "Database.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "TestFolder.h"
#include "refusal.h"

namespace roomgraph {
namespace {

TEST(Database, valuesComeBackAsTheyWere) {
  const TestFolder folder;
  Database database(folder / "a.db", true);
  database.run("CREATE TABLE t (a TEXT, b REAL, c INTEGER, d REAL)");
  const std::string odd("a'b\0c\xc3\xa9", 7);
  database.run("INSERT INTO t VALUES (?, ?, ?, ?)", odd, 0.1, std::int64_t(1) << 40,
               std::optional<double>());
  Statement row(database, "SELECT * FROM t");
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.text(0), odd);
  EXPECT_EQ(row.number(1), 0.1);
  EXPECT_EQ(row.integer(2), std::int64_t(1) << 40);
  EXPECT_FALSE(row.numberIfAny(3));
  EXPECT_FALSE(row.step());
}

TEST(Database, whatIsNotCommittedIsUndone) {
  const TestFolder folder;
  Database database(folder / "a.db", true);
  database.run("CREATE TABLE t (a INTEGER)");
  {
    Transaction transaction(database);
    database.run("INSERT INTO t VALUES (1)");
  }
  EXPECT_EQ(database.number("SELECT count(*) FROM t"), 0);
  Transaction transaction(database);
  database.run("INSERT INTO t VALUES (1)");
  transaction.commit();
  EXPECT_EQ(database.number("SELECT count(*) FROM t"), 1);
  EXPECT_EQ(database.number("SELECT count(*) FROM t WHERE a = ?", 1), 1);
}

TEST(Database, aNameWithAMeaningForSqliteIsAFile) {
  const TestFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  { Database(":memory:", true).run("CREATE TABLE t (a INTEGER)"); }
  EXPECT_TRUE(std::filesystem::exists(":memory:"));
  std::filesystem::current_path(before);
}

TEST(Database, anEmptyFileIsNoArchive) {
  const TestFolder folder;
  const std::string file = folder / "a.db";
  std::ofstream(file).close();
  for (const bool mayMake : {false, true})
    EXPECT_EQ(test::refusalOf([&] { Database(file, mayMake); }),
              file +
                  ": is empty: it may have been lost in a crash or a copy: bring back a copy of "
                  "it, or delete it to begin a new one");
  EXPECT_EQ(std::filesystem::file_size(file), 0u);
}

TEST(Database, onesThatNothingWasWrittenToLeaveNoFile) {
  const TestFolder folder;
  const std::string file = folder / "a.db";
  Database(file, true).run("PRAGMA user_version");
  EXPECT_FALSE(std::filesystem::exists(file));
  Database(file, true).run("CREATE TABLE t (a INTEGER)");
  EXPECT_GT(std::filesystem::file_size(file), 0u);
}

TEST(Database, failuresAreOneLineWithFileAndRemedy) {
  const TestFolder folder;
  const std::string text = folder / "text.db";
  std::ofstream(text) << std::string(4096, 'x');
  for (const std::string& file : {folder / "none.db", text}) {
    const std::string line = test::refusalOf(
        [&] { Database(file, false).number("SELECT count(*) FROM sqlite_schema"); });
    EXPECT_EQ(line.rfind(file + ": ", 0), 0U) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "none.db"));
}

TEST(Database, aNameThatLeadsNowhereIsRefused) {
  const TestFolder folder;
  std::filesystem::create_symlink(folder / "b.db", folder / "a.db");
  std::filesystem::create_symlink(folder / "a.db", folder / "b.db");
  for (const bool mayMake : {false, true}) {
    const std::string text = test::refusalOf([&] { Database(folder / "a.db", mayMake); });
    EXPECT_NE(text.find("cannot be opened ("), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace roomgraph
