#include "roomgraph/base/zip_archive.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Little-endian, of `count` bytes. */
std::size_t number(const std::string& bytes, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8u | std::uint8_t(bytes.at(at + i));
  return value;
}

TEST(ZipArchive, holdsItsFilesWhereTheDirectorySays) {
  const std::string zip = zipArchive({{"a.txt", "123456789"}, {"b", std::string(3, '\0')}});
  const std::size_t end = zip.size() - 22;
  ASSERT_EQ(zip.substr(end, 4), "PK\5\6");
  ASSERT_EQ(number(zip, end + 10, 2), 2u);
  std::size_t entry = number(zip, end + 16, 4);
  ASSERT_EQ(entry + number(zip, end + 12, 4), end);
  const std::string names[] = {"a.txt", "b"};
  const std::size_t sizes[] = {9, 3};
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(zip.substr(entry, 4), "PK\1\2");
    ASSERT_EQ(number(zip, entry + 24, 4), sizes[i]);
    ASSERT_EQ(zip.substr(entry + 46, names[i].size()), names[i]);
    const std::size_t file = number(zip, entry + 42, 4);
    ASSERT_EQ(zip.substr(file, 4), "PK\3\4");
    ASSERT_EQ(zip.substr(file + 30, names[i].size()), names[i]);
    ASSERT_EQ(zip.substr(file + 4, 22), zip.substr(entry + 6, 22));
    entry += 46 + names[i].size();
  }
  // The check value of CRC-32, which is that of these digits.
  EXPECT_EQ(number(zip, 14, 4), 0xCBF43926u);
  EXPECT_EQ(zip.substr(35, 9), "123456789");
}

TEST(ZipArchive, ofNothingIsItsEnd) { EXPECT_EQ(zipArchive({}), "PK\5\6" + std::string(18, '\0')); }

TEST(ZipArchive, takesNoMoreFilesThanItCanCount) {
  EXPECT_THROW(zipArchive({65536, {"", ""}}), std::length_error);
}

}  // namespace
}  // namespace roomgraph
