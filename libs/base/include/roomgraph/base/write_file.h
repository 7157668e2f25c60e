#pragma once
#include <string>

namespace roomgraph {

/** Writes `bytes` to `path` so that there is the old file or the whole new one at any time, even if
 *  the machine stops: a file of another name in the same folder is written, flushed to the disk and
 *  renamed. A link is followed, and a file that is there already keeps its permissions. Nothing is
 *  left behind on failure. For several files that belong together see StagedFiles.
 *  @throws DataError with one line (file, problem, remedy). */
void writeFileAtomically(const std::string& path, const std::string& bytes);

/** Makes the folder if it is not there.
 *  @throws DataError with one line where files cannot be written to it. */
void makeWritableFolder(const std::string& folder);

}  // namespace roomgraph
