#pragma once
#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/io/zip.h>
#include <mrpt/serialization/CArchive.h>

#include <memory>
#include <string>
#include <vector>

#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph::test {

/** The scene in a .3Dscene file. */
inline MrptScene sceneOf(const std::string& bytes) {
  std::vector<std::uint8_t> plain;
  EXPECT_TRUE(mrpt::io::zip::decompress_gz_data_block({bytes.begin(), bytes.end()}, plain));
  mrpt::io::CMemoryStream stream(plain.data(), plain.size());
  MrptScene scene;
  mrpt::serialization::archiveFrom(stream) >> scene;
  return scene;
}

/** An object from a stream that knows only its name; it is one that RawLogViewer can show. */
template <class Object>
std::shared_ptr<Object> fromItsName(const Object& sample) {
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << sample;
  stream.Seek(0);
  const auto object = archive.ReadObject();
  EXPECT_NE(dynamic_cast<const viz::Visualizable*>(object.get()), nullptr);
  EXPECT_NE(dynamic_cast<const mrpt::Stringifyable*>(object.get()), nullptr);
  return std::dynamic_pointer_cast<Object>(object);
}

}  // namespace roomgraph::test
