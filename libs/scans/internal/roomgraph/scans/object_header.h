#pragma once
#include <functional>
#include <optional>
#include <string>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

/** How MRPT's streams announce an object. */
struct ObjectHeader {
  std::string className;  ///< without its namespace
  int version = 0;
  /** Objects from before MRPT 0.5.5 have no mark at their end. */
  bool isOldFormat = false;
};

/** Whether a value that may be missing begins at `bytes`: MRPT writes "std::optional" before it. */
bool startsWithOptional(ByteView bytes);

/** The header at `bytes`, if it looks like one. Moves nothing. */
std::optional<ObjectHeader> peekObjectHeader(ByteView bytes);
/** Reads the header. Throws DataError where there is none. */
ObjectHeader readObjectHeader(ByteReader& reader);
/** The mark at an object's end. */
constexpr std::uint8_t kObjectEnd = 0x88;
void readObjectEnd(ByteReader& reader, const ObjectHeader& header);
/** Steps over what is left of an object of any layout: to the first such mark behind which the
 *  bytes are what `follows` asks for. Throws DataError where there is none. */
void skipObject(ByteReader& reader, const std::function<bool(ByteView)>& follows);
/** Throws DataError unless the version is one of 0 to `newest`. */
void checkVersion(const ByteReader& reader, const ObjectHeader& header, int newest);

}  // namespace roomgraph
