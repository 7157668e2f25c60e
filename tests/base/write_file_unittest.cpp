#include "roomgraph/base/write_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "TestFolder.h"
#include "refusal.h"

namespace roomgraph {
namespace {

using Names = std::vector<std::string>;

TEST(WriteFile, writesAllBytesAndNothingElse) {
  const TestFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  writeFileAtomically(folder / "file", bytes);
  EXPECT_EQ(readAll(folder / "file"), bytes);
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(WriteFile, replacesAnOlderFile) {
  const TestFolder folder;
  writeFileAtomically(folder / "file", "a longer text");
  writeFileAtomically(folder / "file", "short");
  EXPECT_EQ(readAll(folder / "file"), "short");
}

TEST(WriteFile, followsALinkAndKeepsIt) {
  const TestFolder folder;
  writeFileAtomically(folder / "real", "old");
  std::filesystem::create_symlink("real", folder / "link");
  writeFileAtomically(folder / "link", "new");
  EXPECT_EQ(readAll(folder / "real"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
}

TEST(WriteFile, keepsThePermissionsOfTheFileThatItReplaces) {
  using std::filesystem::perms;
  const TestFolder folder;
  writeFileAtomically(folder / "file", "old");
  for (const int mode : {0664, 0600, 0666}) {  // the umask would take some of these away
    std::filesystem::permissions(folder / "file", perms(mode));
    writeFileAtomically(folder / "file", "new");
    EXPECT_EQ(std::filesystem::status(folder / "file").permissions(), perms(mode));
  }
}

/** The message, which must be one line that starts with the file's name. */
std::string refusedWrite(const std::string& path) {
  return test::refusalOf([&] { writeFileAtomically(path, "text"); });
}

TEST(WriteFile, aFolderThatIsNotThereIsAnErrorOfOneLine) {
  const TestFolder folder;
  const std::string message = refusedWrite(folder / "missing/file");
  EXPECT_EQ(message.find(folder / "missing/file: cannot be written"), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteFile, doesNotReplaceAFolderOrADevice) {
  const TestFolder folder;
  std::filesystem::create_directory(folder / "sub");
  EXPECT_NE(refusedWrite(folder / "sub").find("not a regular file"), std::string::npos);
  EXPECT_EQ(folder.names(), Names{"sub"});
  EXPECT_NE(refusedWrite("/dev/null").find("not a regular file"), std::string::npos);
}

TEST(WriteFile, leavesNothingBehindWhereTheRenamingFails) {
  const TestFolder folder;
  // The name is as long as may be, so that of the part file is too long.
  const std::string name(255, 'n');
  EXPECT_NE(refusedWrite(folder / name), "");
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace roomgraph
