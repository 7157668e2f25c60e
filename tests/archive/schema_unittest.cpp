#include "schema.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "TestFolder.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(Schema, anOlderArchiveIsBroughtUpToDateAndKeepsWhatItHas) {
  const TestFolder folder;
  Database database(folder / "a.db", true);
  std::vector<std::string> steps{"CREATE TABLE t (a INTEGER)"};
  migrate(database, steps);
  database.run("INSERT INTO t VALUES (7)");
  steps.push_back("ALTER TABLE t ADD COLUMN b INTEGER DEFAULT 3");
  steps.push_back("UPDATE t SET b = a + b");
  migrate(database, steps);
  EXPECT_EQ(database.number("SELECT b FROM t"), 10);
  migrate(database, steps);  // nothing is done twice
  EXPECT_EQ(database.number("SELECT b FROM t"), 10);
}

TEST(Schema, aStepThatFailsChangesNothing) {
  const TestFolder folder;
  Database database(folder / "a.db", true);
  migrate(database, {"CREATE TABLE t (a INTEGER)"});
  EXPECT_THROW(migrate(database, {"", "INSERT INTO t VALUES (1); INSERT INTO none VALUES (1)"}),
               DataError);
  EXPECT_EQ(database.number("SELECT count(*) FROM t"), 0);
  EXPECT_EQ(database.number("PRAGMA user_version"), 1);
}

TEST(Schema, aLaterArchiveAndOtherDatabasesAreRefused) {
  const TestFolder folder;
  Database later(folder / "later.db", true);
  migrate(later, schemaSteps());
  later.run("PRAGMA user_version = 99");
  EXPECT_THROW(migrate(later, schemaSteps()), DataError);
  Database other(folder / "other.db", true);
  other.run("CREATE TABLE t (a INTEGER)");
  EXPECT_THROW(migrate(other, schemaSteps()), DataError);
  EXPECT_EQ(other.number("PRAGMA application_id"), 0);
}

TEST(Schema, severalThreadsMakeOneArchive) {
  const TestFolder folder;
  for (int round = 0; round < 10; ++round) {
    const std::string file = folder / (std::to_string(round) + ".db");
    std::atomic<int> failures{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 6; ++i)
      threads.emplace_back([&] {
        try {
          Database database(file, true);
          database.tryRun("PRAGMA journal_mode = WAL");
          migrate(database, schemaSteps());
        } catch (const DataError&) {
          ++failures;
        }
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    Database database(file, false);
    EXPECT_EQ(database.number("PRAGMA user_version"), std::int64_t(schemaSteps().size()));
  }
}

}  // namespace
}  // namespace roomgraph
