#include "roomgraph/base/StagedFiles.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <filesystem>

#include "TestFolder.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"

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

TEST(StagedFiles, canBeReadBeforeTheCommit) {
  const Older older;
  StagedFiles files;
  EXPECT_EQ(readAll(files.add(older.folder / "a", "new a")), "new a");
  older.expectUntouched();
}

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

TEST(StagedFiles, aNameMayBeAsLongAsItsFolderHasRoomForItsSuffix) {
  const TestFolder folder;
  writeFileAtomically(folder / std::string(NAME_MAX - StagedFiles::kLongestSuffix, 'x'), "text");
  EXPECT_THROW(writeFileAtomically(folder / std::string(NAME_MAX, 'x'), "text"), DataError);
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

TEST(StagedFiles, whatCannotTakeItsPlaceLeavesTheOthersAsTheyWere) {
  const Older older;
  std::filesystem::create_hard_link(older.folder / "a", older.folder / "link to a");
  {
    StagedFiles files;
    files.add(older.folder / "a", "new a");
    files.add(older.folder / "d", "new d");
    files.add(older.folder / "c", "new c");
    files.add(older.folder / "b", "new b");
    std::filesystem::create_directory(older.folder / "c");
    EXPECT_THROW(files.commit(), DataError);
  }
  older.expectUntouched();
  EXPECT_EQ(older.folder.names(), (Names{"a", "b", "c", "link to a"}));
  EXPECT_TRUE(std::filesystem::equivalent(older.folder / "a", older.folder / "link to a"))
      << "a copy of the file is there, and not the file";
}

/** Does the work in a process of its own, which then stops without any destructor. */
template <class Work>
void stopAfter(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
}

TEST(StagedFiles, whatAKilledProcessLeftGoesWithTheNextOne) {
  const Older older;
  StagedFiles held;  // another writer, who is at work
  held.add(older.folder / "a", "held");
  stopAfter([&] { (new StagedFiles)->add(older.folder / "a", "killed"); });
  EXPECT_EQ(older.folder.names().size(), 4u) << "two parts";
  StagedFiles files;
  files.add(older.folder / "a", "new a");
  EXPECT_EQ(older.folder.names().size(), 4u) << "that of the killed one is gone";
  files.commit();
  EXPECT_EQ(readAll(older.folder / "a"), "new a");
  held.commit();
  EXPECT_EQ(readAll(older.folder / "a"), "held");
  EXPECT_EQ(older.folder.names(), (Names{"a", "b"}));
}

TEST(StagedFiles, aThousandNamesThatAreTakenBlockNoOther) {
  const TestFolder folder;
  for (int i = 0; i < 1000; ++i)
    std::filesystem::create_directory(folder / ("a.roomgraph-part" + std::to_string(i)));
  writeFileAtomically(folder / "a", "text");
  EXPECT_EQ(readAll(folder / "a"), "text");
}

TEST(StagedFiles, aProcessThatEndsEarlyTakesItsPartsAlong) {
  const Older older;
  stopAfter([&] {
    auto* files = new StagedFiles;  // never destroyed, as all calls wait from now on
    files->add(older.folder / "a", "new a");
    files->add(older.folder / "c", "new c");
    StagedFiles::abandonAll();
  });
  older.expectUntouched();
  EXPECT_EQ(older.folder.names(), (Names{"a", "b"}));
}

}  // namespace
}  // namespace roomgraph
