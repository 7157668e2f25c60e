#pragma once
#include <functional>
#include <string>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

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
