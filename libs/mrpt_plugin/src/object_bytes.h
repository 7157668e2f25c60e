#pragma once
#include <functional>
#include <string>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** An object as MRPT streams it, gzipped. No time stamp: the same object gives the same bytes. */
std::string gzippedObject(const mrpt::serialization::CSerializable& object);

/** The object as MRPT streams it. */
std::string objectBytes(const mrpt::serialization::CSerializable& object);

// What the classes of this library have in common: in a stream, each is the size of its bytes and
// these bytes.

/** Which object is read from a stream. */
struct BodyKind {
  const char* name;             ///< for messages
  int version = 0, newest = 0;  ///< of its layout: what the stream says, and what is known here
};

void putBody(mrpt::serialization::CArchive& out, const std::string& bytes);

/** Reads what the stream claims to hold piece by piece: a false claim costs no memory.
 *  @throws DataError with one line. */
std::string takeBody(mrpt::serialization::CArchive& in, const BodyKind& kind);

/** What kind of object a file is to hold. */
struct ObjectKind {
  const char *className, *name;  ///< without its namespace; for people
  const char* remedy;
  int newest = 0;  ///< version of the layout that is known
};

/** Calls `read` with the bytes of the one object in a file, gzipped or not.
 *  @throws DataError with one line where the file holds another object, or more than that. */
void readObjectFile(const std::string& path, const ObjectKind& kind,
                    const std::function<void(ByteView)>& read);

}  // namespace roomgraph
