#include "roomgraph/base/compressed.h"

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "roomgraph/base/write_file.h"

namespace roomgraph {
namespace {

TEST(Compressed, isReadBackAsItWasStored) {
  const TestFolder folder;
  std::string bytes(200'000, 'a');
  for (std::size_t i = 0; i < bytes.size(); i += 7) bytes[i] = char(i * i % 251);
  for (const Compression how : {Compression::none, Compression::gzip, Compression::zstd}) {
    const std::string name = folder / nameOf(how);
    writeFileAtomically(name, compressed(bytes, how));
    CheckedFile file(name);
    const ByteView read = file.content();
    EXPECT_EQ(file.compression(), how);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(read.data), read.size), bytes);
    EXPECT_EQ(compressed(bytes, how), compressed(bytes, how));
  }
}

TEST(Gzipped, keepsItsCommentInTheHeaderAndOutOfTheContent) {
  const TestFolder folder;
  const std::string file = gzipped("content", kGzipMark);
  EXPECT_EQ(file.find(kGzipMark), 10u) << "right behind the fields that each header has";
  writeFileAtomically(folder / "a", file);
  CheckedFile opened(folder / "a");
  const ByteView read = opened.content();
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(read.data), read.size), "content");
  EXPECT_EQ(gzipped("content", {}), compressed("content", Compression::gzip));
}

}  // namespace
}  // namespace roomgraph
