#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>

namespace roomgraph {

/** Where a map's results go: folder/X.extension, see mapStem. */
std::string outputFile(const std::string& folder, const std::string& mapFile,
                       const std::string& extension);

/** A file of this name in the folder. */
std::string inFolder(const std::string& folder, const std::string& name);

/** The name of a mended run: "run01.repaired.simplemap.gz" of "run01.simplemap.gz". */
std::string repairedName(const std::string& file);

/** What tells a file from all others, whatever its name. */
using FileIdentity = std::pair<dev_t, ino_t>;

/** None where there is no such file. */
std::optional<FileIdentity> identityOf(const std::string& file);

/** Whether two names are of one file, which must exist. */
bool areSameFile(const std::string& one, const std::string& other);

/** The whole name of a file that need not be there yet, with the links that are there followed. */
std::string placeOnDisk(const std::string& file);

/** Whether two names are of one file once both are written; none need be there yet. */
bool wouldBeSameFile(const std::string& one, const std::string& other);

}  // namespace roomgraph
