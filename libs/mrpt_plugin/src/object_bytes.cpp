#include "object_bytes.h"

#include <mrpt/io/CMemoryStream.h>
#include <zlib.h>

#include <limits>
#include <new>
#include <stdexcept>

namespace roomgraph {

std::string gzipped(const std::string& bytes) {
  if (bytes.size() > std::numeric_limits<uInt>::max())
    throw std::length_error("the object is larger than 4 GB");
  z_stream stream{};
  // A scene compresses nearly as well at the lowest level, in a third of the time.
  constexpr int gzipFrame = 16 + MAX_WBITS, memory = 8;
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, gzipFrame, memory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  std::string out(deflateBound(&stream, uLong(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);  // cannot fail: there is room for all of it
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string objectBytes(const mrpt::serialization::CSerializable& object) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()),
          std::size_t(stream.getTotalBytesCount())};
}

std::string gzippedObject(const mrpt::serialization::CSerializable& object) {
  return gzipped(objectBytes(object));
}

}  // namespace roomgraph
