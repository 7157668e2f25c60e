#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

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

}  // namespace roomgraph
