#include "schema.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "TestFolder.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(Schema, aLaterArchiveAndOtherDatabasesAreRefused) {
  const TestFolder folder;
  Database later(folder / "later.db", true);
  migrate(later);
  later.run("PRAGMA user_version = 99");
  EXPECT_THROW(migrate(later), DataError);
  Database other(folder / "other.db", true);
  other.run("CREATE TABLE t (a INTEGER)");
  EXPECT_THROW(migrate(other), DataError);
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
          migrate(database);
        } catch (const DataError&) {
          ++failures;
        }
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    Database database(file, false);
    EXPECT_EQ(database.number("PRAGMA user_version"), 1);
  }
}

}  // namespace
}  // namespace roomgraph
