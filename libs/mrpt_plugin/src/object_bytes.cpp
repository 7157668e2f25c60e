#include "object_bytes.h"

#include <mrpt/io/CMemoryStream.h>

#include "roomgraph/base/compressed.h"

namespace roomgraph {

std::string objectBytes(const mrpt::serialization::CSerializable& object) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()),
          std::size_t(stream.getTotalBytesCount())};
}

std::string gzippedObject(const mrpt::serialization::CSerializable& object) {
  return compressed(objectBytes(object), Compression::gzip);
}

}  // namespace roomgraph
