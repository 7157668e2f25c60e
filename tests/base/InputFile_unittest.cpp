#include "roomgraph/base/InputFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>

#include "TestFolder.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"

/** The linker leads calls of fstat() here. */
bool doesDiskFail = false;
extern "C" int __real_fstat(int file, struct stat* status);
extern "C" int __wrap_fstat(int file, struct stat* status) {
  if (!doesDiskFail) return __real_fstat(file, status);
  errno = EIO;
  return -1;
}

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

/** In a folder of its own, gone with the test. */
class InputFileTest : public testing::Test {
 protected:
  const TestFolder folder_;
};

std::string refusal(const std::string& name, std::uint64_t most = 100) {
  return test::refusalOf([&] { readFile(name, most); });
}

TEST_F(InputFileTest, givesAllBytes) {
  const std::string bytes("a\0b\n\xff", 5);
  EXPECT_EQ(readFile(folder_.write("file", bytes)), bytes);
  EXPECT_EQ(readFile(folder_.write("empty", "")), "");
  char two[2];
  InputFile(folder_ / "file", 5).read(1, two, 2);
  EXPECT_EQ(std::string(two, 2), std::string("\0b", 2));
}

TEST_F(InputFileTest, refusesAtOnceWhatMayHaveNoEnd) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", folder_ / "zeros");
  for (const char* name : {"pipe", "zeros"})
    EXPECT_NE(refusal(folder_ / name).find("is a pipe or a device"), std::string::npos) << name;
  EXPECT_NE(refusal(folder_.path()).find("is a directory"), std::string::npos);
}

TEST_F(InputFileTest, refusesWhatIsTooLargeBeforeReadingIt) {
  folder_.write("large", "");
  fs::resize_file(folder_ / "large", 3'000'000'000);
  EXPECT_NE(refusal(folder_ / "large", 2'000'000'000).find("is larger than 2 GB"),
            std::string::npos);
  EXPECT_NE(refusal(folder_ / "large", 5'000'000).find("is larger than 5 MB"), std::string::npos);
}

TEST_F(InputFileTest, namesWhatIsNotThere) {
  EXPECT_EQ(refusal(folder_ / "none"),
            folder_ / "none" + ": there is no such file: check the name");
  EXPECT_EQ(refusal(""), "'': there is no such file: check the name");
  folder_.write("file", "bytes");
  EXPECT_NE(refusal(folder_ / "file/below").find("no such file"), std::string::npos);
}

TEST_F(InputFileTest, saysWhereAFileEndsEarly) {
  const InputFile file(folder_.write("file", "bytes"), 100);
  fs::resize_file(folder_ / "file", 2);
  char all[5];
  EXPECT_THROW(file.read(0, all, 5), DataError);
}

TEST_F(InputFileTest, aDiskThatFailsIsNoDamage) {
  const std::string name = "/proc/self/mem";  // whose first page nobody can read
  char byte;
  EXPECT_EQ(test::refusalOf([&] { InputFile(name, 100).read(0, &byte, 1); }),
            name +
                ": cannot be read (Input/output error): check the disk or the network that it is "
                "on");
  doesDiskFail = true;
  const std::string text = refusal(folder_.write("file", "bytes"));
  doesDiskFail = false;
  EXPECT_NE(text.find("cannot be looked at (Input/output error)"), std::string::npos) << text;
}

}  // namespace
}  // namespace roomgraph
