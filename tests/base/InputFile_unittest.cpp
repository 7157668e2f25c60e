#include "roomgraph/base/InputFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

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
  InputFileTest() {
    std::string pattern = testing::TempDir() + "input_file_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~InputFileTest() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  std::string written(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  std::string folder_;
};

std::string refusal(const std::string& name, std::uint64_t most = 100) {
  return test::refusalOf([&] { readFile(name, most); });
}

TEST_F(InputFileTest, givesAllBytes) {
  const std::string bytes("a\0b\n\xff", 5);
  EXPECT_EQ(readFile(written("file", bytes)), bytes);
  EXPECT_EQ(readFile(written("empty", "")), "");
  char two[2];
  InputFile(path("file"), 5).read(1, two, 2);
  EXPECT_EQ(std::string(two, 2), std::string("\0b", 2));
}

TEST_F(InputFileTest, refusesAtOnceWhatMayHaveNoEnd) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", path("zeros"));
  for (const char* name : {"pipe", "zeros"})
    EXPECT_NE(refusal(path(name)).find("is a pipe or a device"), std::string::npos) << name;
  EXPECT_NE(refusal(folder_).find("is a directory"), std::string::npos);
}

TEST_F(InputFileTest, refusesWhatIsTooLargeBeforeReadingIt) {
  written("large", "");
  fs::resize_file(path("large"), 3'000'000'000);
  EXPECT_NE(refusal(path("large"), 2'000'000'000).find("is larger than 2 GB"), std::string::npos);
  EXPECT_NE(refusal(path("large"), 5'000'000).find("is larger than 5 MB"), std::string::npos);
}

TEST_F(InputFileTest, namesWhatIsNotThere) {
  EXPECT_EQ(refusal(path("none")), path("none") + ": there is no such file: check the name");
  EXPECT_EQ(refusal(""), "'': there is no such file: check the name");
  written("file", "bytes");
  EXPECT_NE(refusal(path("file/below")).find("no such file"), std::string::npos);
}

TEST_F(InputFileTest, saysWhereAFileEndsEarly) {
  const InputFile file(written("file", "bytes"), 100);
  fs::resize_file(path("file"), 2);
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
  const std::string text = refusal(written("file", "bytes"));
  doesDiskFail = false;
  EXPECT_NE(text.find("cannot be looked at (Input/output error)"), std::string::npos) << text;
}

}  // namespace
}  // namespace roomgraph
