#include "roomgraph/report/StagedFiles.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "roomgraph/base/Error.h"
#include "roomgraph/report/write_file.h"
#include "sample_stages.h"

namespace roomgraph {
namespace {

using Names = std::vector<std::string>;

/** A folder with two older files. */
struct Older {
  Older() {
    writeFileAtomically(folder / "a", "old a");
    writeFileAtomically(folder / "b", "old b");
  }

  void expectUntouched() const {
    EXPECT_EQ(readAll(folder / "a"), "old a");
    EXPECT_EQ(readAll(folder / "b"), "old b");
  }

  const TestFolder folder;
};

TEST(StagedFiles, takeTheirPlacesAtTheCommitAndNotBefore) {
  const Older older;
  StagedFiles files;
  files.add(older.folder / "a", "new a");
  files.add(older.folder / "b", "new b");
  files.add(older.folder / "c", "new c");
  older.expectUntouched();
  EXPECT_FALSE(std::filesystem::exists(older.folder / "c"));
  files.commit();
  for (const std::string name : {"a", "b", "c"})
    EXPECT_EQ(readAll(older.folder / name), "new " + name);
  EXPECT_EQ(older.folder.names(), (Names{"a", "b", "c"}));
}

TEST(StagedFiles, withoutACommitAllIsAsItWas) {
  const Older older;
  {
    StagedFiles files;
    files.add(older.folder / "a", "new a");
    files.add(older.folder / "c", "new c");
  }
  older.expectUntouched();
  EXPECT_EQ(older.folder.names(), (Names{"a", "b"}));
}

TEST(StagedFiles, oneThatCannotBeWrittenLeavesAllAsTheyWere) {
  const Older older;
  std::filesystem::create_directory(older.folder / "sub");
  for (const char* bad : {"sub", "missing/file"}) {
    StagedFiles files;
    files.add(older.folder / "a", "new a");
    EXPECT_THROW(files.add(older.folder / bad, "text"), DataError) << bad;
  }
  older.expectUntouched();
  EXPECT_EQ(older.folder.names(), (Names{"a", "b", "sub"}));
}

TEST(StagedFiles, whatCannotTakeItsPlaceIsRemoved) {
  const Older older;
  {
    StagedFiles files;
    files.add(older.folder / "c", "new c");
    files.add(older.folder / "a", "new a");
    std::filesystem::create_directory(older.folder / "c");
    EXPECT_THROW(files.commit(), DataError);
  }
  older.expectUntouched();
  EXPECT_EQ(older.folder.names(), (Names{"a", "b", "c"}));
}

}  // namespace
}  // namespace roomgraph
